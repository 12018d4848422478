package no.hials.crosscom.gateway.internal.broker;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.Certificate;
import java.security.cert.CertificateFactory;
import javax.net.ssl.TrustManagerFactory;
import no.hials.crosscom.cell.FileException;
import org.jspecify.annotations.Nullable;

/**
 * The settings of the connections to a broker.
 *
 * @param host its name or address
 * @param port its port
 * @param tls whether the connection is encrypted
 * @param version 3 for MQTT 3.1.1, or 5
 * @param clientId the client identifier; null for a random one
 * @param user the user name; null for none
 * @param passwordFile the file of the password, which is read for each connection; null for none
 * @param caFile the certificates to trust, in PEM; null for those of Java
 * @param storeLimit the maximum size of the stored messages in bytes
 */
public record BrokerSettings(
    String host,
    int port,
    boolean tls,
    int version,
    @Nullable String clientId,
    @Nullable String user,
    @Nullable Path passwordFile,
    @Nullable Path caFile,
    long storeLimit) {

  /** Returns these settings with another client identifier. */
  public BrokerSettings withClientId(String id) {
    return new BrokerSettings(host, port, tls, version, id, user, passwordFile, caFile, storeLimit);
  }

  /** Returns the address of the broker. */
  public String url() {
    return (tls ? "ssl" : "tcp")
        + "://"
        + (host.contains(":") ? "[" + host + "]" : host)
        + ":"
        + port;
  }

  /**
   * Returns the password, without the line break.
   *
   * @throws FileException if it cannot be read
   */
  public static String password(Path file) throws FileException {
    try {
      return Files.readString(file).stripTrailing();
    } catch (IOException e) {
      throw FileException.cannot("read", file, e);
    }
  }

  /**
   * Creates a trust manager with the certificates of a file.
   *
   * @throws FileException if the file cannot be read, or has no certificate
   */
  public static TrustManagerFactory trust(Path file) throws FileException {
    try (InputStream in = Files.newInputStream(file)) {
      KeyStore trusted = KeyStore.getInstance(KeyStore.getDefaultType());
      trusted.load(null, null);
      for (Certificate one : CertificateFactory.getInstance("X.509").generateCertificates(in)) {
        trusted.setCertificateEntry(String.valueOf(trusted.size()), one);
      }
      if (trusted.size() == 0) {
        throw new FileException(file + " has no certificate in PEM");
      }
      TrustManagerFactory factory =
          TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
      factory.init(trusted);
      return factory;
    } catch (FileException e) {
      throw e;
    } catch (IOException e) {
      throw FileException.cannot("read", file, e);
    } catch (GeneralSecurityException e) {
      throw new FileException(file + " is not a list of certificates in PEM: " + e.getMessage(), e);
    }
  }
}
