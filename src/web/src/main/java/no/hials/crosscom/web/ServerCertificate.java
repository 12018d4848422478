package no.hials.crosscom.web;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.KeyStore;
import java.security.KeyStoreException;
import java.security.MessageDigest;
import java.security.PrivateKey;
import java.security.Signature;
import java.security.UnrecoverableKeyException;
import java.security.cert.Certificate;
import java.security.cert.CertificateException;
import java.security.cert.CertificateExpiredException;
import java.security.cert.CertificateFactory;
import java.security.cert.CertificateNotYetValidException;
import java.security.cert.CertificateParsingException;
import java.security.cert.X509Certificate;
import java.security.spec.InvalidKeySpecException;
import java.security.spec.PKCS8EncodedKeySpec;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Collection;
import java.util.Collections;
import java.util.Date;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.crypto.Cipher;
import javax.crypto.EncryptedPrivateKeyInfo;
import javax.crypto.SecretKey;
import javax.crypto.SecretKeyFactory;
import javax.crypto.spec.PBEKeySpec;
import no.hials.crosscom.cell.FileException;
import org.jspecify.annotations.Nullable;

/** The certificate of the page's server, with its private key. Immutable. */
public final class ServerCertificate {
  private static final Pattern PEM =
      Pattern.compile("-----BEGIN ([A-Z0-9 ]+)-----([A-Za-z0-9+/=\\s]*)-----END \\1-----");

  private static final int DNS_NAME = 2;
  private static final int IP_ADDRESS = 7;

  private final PrivateKey key;
  private final List<X509Certificate> chain;

  private ServerCertificate(PrivateKey key, List<X509Certificate> chain) {
    this.key = key;
    this.chain = List.copyOf(chain);
  }

  /**
   * Reads a certificate and its key in PEM format.
   *
   * @param certificate the file with the certificate, followed by those of its issuers
   * @param key the file with the key in PKCS #8; may be the same
   * @param password the password of the key; null if it has none
   * @throws FileException if a file cannot be used, or the certificate is not valid now
   */
  public static ServerCertificate ofPem(Path certificate, Path key, char @Nullable [] password)
      throws IOException {
    ServerCertificate read = readPem(certificate, key, password);
    read.checkDates(certificate);
    return read;
  }

  /** Reads a certificate as {@link #ofPem}, even if it has expired. */
  static ServerCertificate readPem(Path certificate, Path key, char @Nullable [] password)
      throws IOException {
    List<X509Certificate> chain = new ArrayList<>();
    try {
      CertificateFactory factory = CertificateFactory.getInstance("X.509");
      for (byte[] block : blocks(certificate, "CERTIFICATE")) {
        chain.add((X509Certificate) factory.generateCertificate(new ByteArrayInputStream(block)));
      }
    } catch (CertificateException e) {
      throw new FileException("cannot read the certificate in " + certificate, e);
    }
    if (chain.isEmpty()) {
      throw new FileException(certificate + " has no certificate in PEM format");
    }
    ServerCertificate read = new ServerCertificate(readKey(key, password), chain);
    read.checkKey(key.equals(certificate) ? certificate.toString() : key + " and " + certificate);
    return read;
  }

  /**
   * Reads the only private key of a key store, in PKCS #12 or JKS format, and its certificate.
   *
   * @throws FileException if the file cannot be used, or the certificate is not valid now
   */
  public static ServerCertificate ofKeyStore(Path file, char @Nullable [] password)
      throws IOException {
    if (!Files.isReadable(file)) {
      throw new FileException("cannot read the key store " + file);
    }
    if (password == null) {
      throw new FileException("the key store " + file + " needs a password");
    }
    try {
      ServerCertificate read = readKeyStore(file, password);
      read.checkDates(file);
      return read;
    } catch (IOException e) {
      if (e.getCause() instanceof UnrecoverableKeyException) {
        throw wrongPassword(file, e);
      }
      throw e instanceof FileException ? e : FileException.cannot("read", file, e);
    } catch (UnrecoverableKeyException e) {
      throw wrongPassword(file, e);
    } catch (KeyStoreException e) {
      throw new FileException(file + " is not a key store in PKCS #12 or JKS format", e);
    } catch (GeneralSecurityException e) {
      throw new FileException("cannot read " + file + ": " + e.getMessage(), e);
    }
  }

  /** Reads a key store, without a check of the dates. */
  static ServerCertificate readKeyStore(Path file, char[] password)
      throws IOException, GeneralSecurityException {
    KeyStore store = KeyStore.getInstance(file.toFile(), password);
    List<String> keys = new ArrayList<>();
    for (String alias : Collections.list(store.aliases())) {
      if (store.isKeyEntry(alias)) {
        keys.add(alias);
      }
    }
    if (keys.size() != 1) {
      throw new FileException(file + " must have one private key, has " + keys.size());
    }
    List<X509Certificate> chain = new ArrayList<>();
    for (Certificate one : store.getCertificateChain(keys.get(0))) {
      chain.add((X509Certificate) one);
    }
    ServerCertificate read =
        new ServerCertificate((PrivateKey) store.getKey(keys.get(0), password), chain);
    read.checkKey(file.toString());
    return read;
  }

  private static FileException wrongPassword(Path file, Exception cause) {
    return new FileException("the password of " + file + " is wrong", cause);
  }

  private static List<byte[]> blocks(Path file, String type) throws IOException {
    List<byte[]> found = new ArrayList<>();
    Matcher block = PEM.matcher(text(file));
    while (block.find()) {
      if (block.group(1).equals(type)) {
        found.add(bytes(file, block));
      }
    }
    return found;
  }

  private static String text(Path file) throws IOException {
    try {
      return Files.readString(file, StandardCharsets.ISO_8859_1);
    } catch (IOException e) {
      throw FileException.cannot("read", file, e);
    }
  }

  private static byte[] bytes(Path file, Matcher block) throws IOException {
    try {
      return Base64.getMimeDecoder().decode(block.group(2));
    } catch (IllegalArgumentException e) {
      throw new FileException(file + " is damaged: " + e.getMessage(), e);
    }
  }

  private static PrivateKey readKey(Path file, char @Nullable [] password) throws IOException {
    Matcher block = PEM.matcher(text(file));
    while (block.find()) {
      String type = block.group(1);
      if (type.equals("PRIVATE KEY")) {
        return key(file, new PKCS8EncodedKeySpec(bytes(file, block)));
      }
      if (type.equals("ENCRYPTED PRIVATE KEY")) {
        if (password == null) {
          throw new FileException("the key in " + file + " needs a password");
        }
        return key(file, decrypt(file, bytes(file, block), password));
      }
      if (type.endsWith(" PRIVATE KEY")) {
        throw oldFormat(file);
      }
    }
    throw new FileException(file + " has no private key in PEM format");
  }

  private static FileException oldFormat(Path file) {
    return new FileException(
        file
            + " has a key in an old format; convert it with: openssl pkcs8 -topk8 -v2 aes-256-cbc"
            + " -in "
            + file
            + " -out key.pem");
  }

  private static PKCS8EncodedKeySpec decrypt(Path file, byte[] bytes, char[] password)
      throws IOException {
    try {
      EncryptedPrivateKeyInfo info = new EncryptedPrivateKeyInfo(bytes);
      // the name of the scheme with its parts: the name PBES2 alone does not show them
      String scheme = info.getAlgParameters().toString();
      SecretKey secret =
          SecretKeyFactory.getInstance(scheme).generateSecret(new PBEKeySpec(password));
      Cipher cipher = Cipher.getInstance(scheme);
      cipher.init(Cipher.DECRYPT_MODE, secret, info.getAlgParameters());
      return info.getKeySpec(cipher);
    } catch (InvalidKeySpecException e) {
      throw wrongPassword(file, e);
    } catch (GeneralSecurityException | IOException e) {
      FileException refused = oldFormat(file); // such as DES, which OpenSSL used for years
      refused.initCause(e);
      throw refused;
    }
  }

  private static PrivateKey key(Path file, PKCS8EncodedKeySpec spec) throws IOException {
    for (String algorithm : List.of("EC", "RSA", "EdDSA")) {
      try {
        return KeyFactory.getInstance(algorithm).generatePrivate(spec);
      } catch (GeneralSecurityException e) {
        // the key is of another algorithm
      }
    }
    throw new FileException("the key in " + file + " must be one of EC, RSA or EdDSA");
  }

  /** Checks that the key belongs to the certificate: it signs, and the certificate verifies. */
  private void checkKey(String files) throws IOException {
    String algorithm =
        switch (key.getAlgorithm()) {
          case "EC" -> "SHA256withECDSA";
          case "RSA" -> "SHA256withRSA";
          default -> key.getAlgorithm();
        };
    try {
      Signature signature = Signature.getInstance(algorithm);
      byte[] text = {1};
      signature.initSign(key);
      signature.update(text);
      byte[] signed = signature.sign();
      signature.initVerify(chain.get(0).getPublicKey());
      signature.update(text);
      if (signature.verify(signed)) {
        return;
      }
    } catch (GeneralSecurityException e) {
      // the key is of another kind than the certificate
    }
    throw new FileException("the private key does not match the certificate: " + files);
  }

  private void checkDates(Path file) throws IOException {
    try {
      chain.get(0).checkValidity();
    } catch (CertificateExpiredException e) {
      throw new FileException("the certificate in " + file + " expired on " + end(), e);
    } catch (CertificateNotYetValidException e) {
      Instant start = chain.get(0).getNotBefore().toInstant();
      throw new FileException("the certificate in " + file + " is not valid before " + start, e);
    }
  }

  /** Returns the end of the validity. */
  public Instant end() {
    return chain.get(0).getNotAfter().toInstant();
  }

  /** Returns whether it is valid at a time. */
  boolean isValid(Instant time) {
    try {
      chain.get(0).checkValidity(Date.from(time));
      return true;
    } catch (CertificateExpiredException | CertificateNotYetValidException e) {
      return false;
    }
  }

  /** Returns the SHA-256 of the certificate, as browsers show it. */
  public String fingerprint() {
    try {
      byte[] hash = MessageDigest.getInstance("SHA-256").digest(chain.get(0).getEncoded());
      return HexFormat.ofDelimiter(":").withUpperCase().formatHex(hash);
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException(e); // every JVM has SHA-256, and the certificate was read
    }
  }

  /** Returns whether the certificate names a host, in the form of {@link PageAddress#names}. */
  public boolean isFor(String host) {
    String plain = host.startsWith("[") ? host.substring(1, host.length() - 1) : host;
    try {
      Collection<List<?>> names = chain.get(0).getSubjectAlternativeNames();
      return names != null
          && names.stream().anyMatch(it -> matches((Integer) it.get(0), "" + it.get(1), plain));
    } catch (CertificateParsingException e) {
      return false;
    }
  }

  private static boolean matches(int type, String name, String host) {
    String pattern = name.toLowerCase(Locale.ROOT);
    int dot = host.indexOf('.');
    return (type == IP_ADDRESS && pattern.equals(host))
        || (type == DNS_NAME && pattern.equals(host))
        || (type == DNS_NAME && dot > 0 && pattern.equals("*" + host.substring(dot)));
  }

  /** Returns a key store in memory with the key and its certificate. */
  KeyStore keyStore(char[] password) {
    try {
      KeyStore store = KeyStore.getInstance("PKCS12");
      store.load(null, null);
      store.setKeyEntry("page", key, password, chain.toArray(X509Certificate[]::new));
      return store;
    } catch (GeneralSecurityException | IOException e) {
      throw new IllegalStateException(e); // nothing is read or written
    }
  }

  /** Returns the key and the certificate in PEM format. */
  String pem() {
    try {
      return pem("PRIVATE KEY", key.getEncoded()) + pem("CERTIFICATE", chain.get(0).getEncoded());
    } catch (CertificateException e) {
      throw new IllegalStateException(e); // it was read
    }
  }

  private static String pem(String type, byte[] bytes) {
    String text = Base64.getMimeEncoder(64, new byte[] {'\n'}).encodeToString(bytes);
    return "-----BEGIN " + type + "-----\n" + text + "\n-----END " + type + "-----\n";
  }
}
