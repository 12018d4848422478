package no.hials.crosscom.gateway.internal.opcua;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InterfaceAddress;
import java.net.NetworkInterface;
import java.net.UnknownHostException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.KeyPair;
import java.security.MessageDigest;
import java.security.Security;
import java.security.cert.X509Certificate;
import java.time.Period;
import java.util.Collections;
import java.util.HexFormat;
import java.util.LinkedHashSet;
import java.util.Set;
import org.bouncycastle.jce.provider.BouncyCastleProvider;
import org.eclipse.milo.opcua.stack.core.NodeIds;
import org.eclipse.milo.opcua.stack.core.security.CertificateManager;
import org.eclipse.milo.opcua.stack.core.security.CertificateQuarantine;
import org.eclipse.milo.opcua.stack.core.security.DefaultApplicationGroup;
import org.eclipse.milo.opcua.stack.core.security.DefaultCertificateManager;
import org.eclipse.milo.opcua.stack.core.security.DefaultServerCertificateValidator;
import org.eclipse.milo.opcua.stack.core.security.FileBasedCertificateQuarantine;
import org.eclipse.milo.opcua.stack.core.security.FileBasedTrustListManager;
import org.eclipse.milo.opcua.stack.core.security.KeyStoreCertificateStore;
import org.eclipse.milo.opcua.stack.core.security.RsaSha256CertificateFactory;
import org.eclipse.milo.opcua.stack.core.util.CertificateUtil;
import org.eclipse.milo.opcua.stack.core.util.SelfSignedCertificateBuilder;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The certificates of the server: its own, those of clients it trusts, and those it has rejected.
 *
 * @param manager the certificates as the server uses them
 * @param certificate the server's own
 * @param applicationUri the name of the server in its certificate
 * @param trusted reads the folder of trusted certificates
 */
record Pki(
    CertificateManager manager,
    X509Certificate certificate,
    String applicationUri,
    FileBasedTrustListManager trusted)
    implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Pki.class);
  private static final Period VALIDITY = Period.ofYears(10);

  /**
   * The format needs a password. The key is protected by the permissions of its file, as a password
   * in another file would be.
   */
  private static final String STORE_PASSWORD = "jopenshowvar";

  /** Opens a folder of certificates, and creates it and the own certificate if they are missing. */
  static Pki open(Path folder, String host) throws IOException {
    if (Security.getProvider(BouncyCastleProvider.PROVIDER_NAME) == null) {
      // Milo asks for RSA-PSS by a name that the JDK does not know
      Security.addProvider(new BouncyCastleProvider());
    }
    FileBasedTrustListManager trusted = null;
    try {
      Path own = Files.createDirectories(folder.resolve("own"));
      protect(own, "rwx------");
      Path store = own.resolve("gateway.p12");
      boolean first = Files.notExists(store);
      trusted = FileBasedTrustListManager.createAndInitialize(folder);
      CertificateQuarantine rejected =
          new Rejected(
              Files.createDirectories(folder.resolve("rejected")),
              folder.resolve("trusted").resolve("certs"));
      if (first) {
        // a full disk or the end of the process must not leave a part of it
        Path part = own.resolve("gateway.p12.part");
        Files.deleteIfExists(part);
        var unused = group(part, host, trusted, rejected);
        Files.move(part, store, StandardCopyOption.ATOMIC_MOVE);
      }
      DefaultApplicationGroup group;
      try {
        group = group(store, host, trusted, rejected);
      } catch (Exception e) {
        throw new IOException(
            store
                + " cannot be read ("
                + e.getMessage()
                + "); without it the gateway creates another certificate, which the clients have"
                + " to trust",
            e);
      }
      protect(store, "rw-------");
      X509Certificate certificate =
          group.getCertificateChain(NodeIds.RsaSha256ApplicationCertificateType)
              .orElseThrow(() -> new IOException("no certificate in " + store))[0];
      Files.write(own.resolve("gateway.der"), certificate.getEncoded());
      LOG.info(
          "OPC UA: {} {}, SHA-256 {}",
          first ? "created the certificate" : "the certificate is",
          own.resolve("gateway.der"),
          fingerprint(certificate));
      String uri =
          CertificateUtil.getSanUri(certificate)
              .orElseThrow(() -> new IOException("no application URI in " + store));
      return new Pki(new DefaultCertificateManager(rejected, group), certificate, uri, trusted);
    } catch (Exception e) {
      if (trusted != null) {
        trusted.close();
      }
      throw new IOException(
          "[opcua] cannot use the certificates in " + folder + ": " + e.getMessage(), e);
    }
  }

  /** Opens a file with the own certificate, and creates it if it is missing. */
  private static DefaultApplicationGroup group(
      Path store, String host, FileBasedTrustListManager trusted, CertificateQuarantine rejected)
      throws Exception {
    return DefaultApplicationGroup.createAndInitialize(
        trusted,
        KeyStoreCertificateStore.createAndInitialize(
            new KeyStoreCertificateStore.Settings(
                store, STORE_PASSWORD::toCharArray, alias -> STORE_PASSWORD.toCharArray(), false)),
        new OwnCertificate(host),
        new DefaultServerCertificateValidator(trusted, rejected));
  }

  /** Removes the permissions of other users, if the file system has permissions. */
  private static void protect(Path path, String permissions) throws IOException {
    if (FileSystems.getDefault().supportedFileAttributeViews().contains("posix")) {
      Files.setPosixFilePermissions(path, PosixFilePermissions.fromString(permissions));
    }
  }

  private static String fingerprint(X509Certificate certificate) throws Exception {
    return HexFormat.ofDelimiter(":")
        .withUpperCase()
        .formatHex(MessageDigest.getInstance("SHA-256").digest(certificate.getEncoded()));
  }

  /** Keeps the certificates of clients that are not trusted, and logs how to trust them. */
  private static final class Rejected extends FileBasedCertificateQuarantine {
    private final Path folder;
    private final Path trusted;

    Rejected(Path folder, Path trusted) {
      super(folder.toFile());
      this.folder = folder;
      this.trusted = trusted;
    }

    @Override
    public void addRejectedCertificate(X509Certificate certificate) {
      super.addRejectedCertificate(certificate);
      LOG.warn(
          "OPC UA: rejected a client with the certificate {}; to trust it, move its file from {} to"
              + " {}",
          Users.printable(certificate.getSubjectX500Principal().getName()),
          folder,
          trusted);
    }
  }

  /** Creates the certificate at the first start. */
  private static final class OwnCertificate extends RsaSha256CertificateFactory {
    private final String host;

    OwnCertificate(String host) {
      this.host = host;
    }

    @Override
    protected X509Certificate[] createRsaSha256CertificateChain(KeyPair keys) throws Exception {
      String computer = computerName();
      SelfSignedCertificateBuilder builder =
          new SelfSignedCertificateBuilder(keys)
              .setCommonName("JOpenShowVar gateway")
              .setApplicationUri("urn:" + computer + ":jopenshowvar:gateway")
              .setValidityPeriod(VALIDITY);
      Set<String> names = new LinkedHashSet<>(Set.of(computer, "localhost"));
      Set<String> addresses = new LinkedHashSet<>();
      InetAddress address = InetAddress.getByName(host);
      if (address.isAnyLocalAddress()) {
        for (NetworkInterface one : Collections.list(NetworkInterface.getNetworkInterfaces())) {
          for (InterfaceAddress its : one.getInterfaceAddresses()) {
            addresses.add(its.getAddress().getHostAddress().replaceFirst("%.*", ""));
          }
        }
      } else {
        addresses.add(address.getHostAddress().replaceFirst("%.*", ""));
        if (!host.equals(address.getHostAddress())) {
          names.add(host);
        }
      }
      names.forEach(builder::addDnsName);
      addresses.forEach(builder::addIpAddress);
      return new X509Certificate[] {builder.build()};
    }
  }

  /** Returns the name of this computer. */
  static String computerName() {
    try {
      return InetAddress.getLocalHost().getHostName();
    } catch (UnknownHostException e) {
      return "localhost";
    }
  }

  @Override
  public void close() throws IOException {
    trusted.close();
  }
}
