package no.hials.crosscom.web;

import static no.hials.crosscom.web.TestCertificates.PASSWORD;
import static no.hials.crosscom.web.TestCertificates.keyStore;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import no.hials.crosscom.cell.FileException;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Certificates from files, and the one that is made. */
class ServerCertificateTest {
  @TempDir private static Path shared;
  private static ServerCertificate any;

  @TempDir private Path dir;

  @BeforeAll
  static void createOne() throws Exception {
    any = ServerCertificate.ofKeyStore(keyStore(shared.resolve("a.p12")), PASSWORD);
  }

  private Path pem(String name, String text) throws IOException {
    return Files.writeString(dir.resolve(name), text);
  }

  private static void assertRefused(ThrowingCallable reading, String... parts) {
    assertThatExceptionOfType(FileException.class)
        .isThrownBy(reading)
        .satisfies(e -> assertThat(e.getMessage()).contains(parts));
  }

  @ParameterizedTest
  @ValueSource(strings = {"EC", "RSA", "Ed25519"})
  void aKeyStoreAndItsPartsInPemFormatAreTheSame(String algorithm) throws Exception {
    Path store = keyStore(dir.resolve("a.p12"), "-keyalg", algorithm);

    ServerCertificate read = ServerCertificate.ofKeyStore(store, PASSWORD);
    Path pem = pem("both.pem", "some text\n" + read.pem());

    assertThat(ServerCertificate.ofPem(pem, pem, null).fingerprint())
        .isEqualTo(read.fingerprint())
        .matches("([0-9A-F]{2}:){31}[0-9A-F]{2}");
  }

  /** As OpenSSL 3 makes them: openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256. */
  @Test
  void aKeyWithAPasswordIsRead() throws Exception {
    Path certificate = resource("openssl-certificate.pem");
    Path key = resource("openssl-key-aes.pem");

    assertThat(ServerCertificate.ofPem(certificate, key, PASSWORD).fingerprint())
        .isEqualTo(
            "3D:7A:FE:67:D6:D1:F9:99:29:A5:F1:23:14:D2:A5:53:EF:83:62:00:EF:41:70:1A:E9:52:EC:3B:D9:01:F0:60");
    assertRefused(
        () -> ServerCertificate.ofPem(certificate, key, "other".toCharArray()),
        "the password of " + key + " is wrong");
    assertRefused(() -> ServerCertificate.ofPem(certificate, key, null), "needs a password");
    assertRefused(
        () -> ServerCertificate.ofPem(certificate, resource("openssl-key-3des.pem"), PASSWORD),
        "old format",
        "-v2 aes-256-cbc");
  }

  private static Path resource(String name) throws Exception {
    return Path.of(ServerCertificateTest.class.getResource(name).toURI());
  }

  @Test
  void filesThatAreNotThereAreNamed() throws Exception {
    Path none = dir.resolve("none.pem");
    Path certificate = pem("certificate.pem", any.pem());

    assertRefused(
        () -> ServerCertificate.ofPem(none, none, null), "cannot read " + none, "file not found");
    assertRefused(() -> ServerCertificate.ofPem(certificate, none, null), "cannot read " + none);
    assertRefused(() -> ServerCertificate.ofKeyStore(none, PASSWORD), none.toString());
  }

  @Test
  void otherFilesAreRefused() throws Exception {
    Path text = pem("text.pem", "no certificate");
    Path damaged =
        pem("damaged.pem", "-----BEGIN CERTIFICATE-----\nAAAA\n-----END CERTIFICATE-----\n");
    Path old = pem("old.pem", any.pem().replace("PRIVATE KEY", "EC PRIVATE KEY"));

    assertRefused(() -> ServerCertificate.ofPem(text, text, null), "no certificate in PEM format");
    assertRefused(() -> ServerCertificate.ofPem(damaged, damaged, null), "cannot read the cert");
    assertRefused(() -> ServerCertificate.ofPem(old, old, null), "old format", "openssl pkcs8");
    assertRefused(
        () -> ServerCertificate.ofKeyStore(text, PASSWORD), "is not a key store in PKCS #12");
  }

  @Test
  void aWrongPasswordIsReported() throws Exception {
    Path store = shared.resolve("a.p12");

    assertRefused(
        () -> ServerCertificate.ofKeyStore(store, "wrong".toCharArray()),
        "the password of " + store + " is wrong");
    assertRefused(() -> ServerCertificate.ofKeyStore(store, null), "needs a password");
  }

  @ParameterizedTest
  @ValueSource(strings = {"EC", "RSA"})
  void aKeyOfAnotherCertificateIsRefused(String algorithm) throws Exception {
    Path certificate = pem("a.pem", any.pem());
    Path key =
        pem(
            "b.pem",
            ServerCertificate.ofKeyStore(
                    keyStore(dir.resolve("b.p12"), "-keyalg", algorithm), PASSWORD)
                .pem());

    assertRefused(
        () -> ServerCertificate.ofPem(certificate, key, null),
        "the private key does not match the certificate",
        key.toString());
  }

  @Test
  void aCertificateThatIsNotValidNowIsRefused() throws Exception {
    Path old =
        keyStore(dir.resolve("old.p12"), "-keyalg", "EC", "-startdate", "-20d", "-validity", "10");
    Path early = keyStore(dir.resolve("early.p12"), "-keyalg", "EC", "-startdate", "+10d");

    assertRefused(() -> ServerCertificate.ofKeyStore(old, PASSWORD), "expired on ");
    assertRefused(() -> ServerCertificate.ofKeyStore(early, PASSWORD), "is not valid before ");
  }

  @Test
  void theNamesOfACertificateAreKnown() throws Exception {
    assertThat(List.of("127.0.0.1", "cell.example", "a.plant.example").stream().filter(any::isFor))
        .hasSize(3);
    assertThat(
            List.of("127.0.0.2", "a.cell.example", "plant.example", "a.b.plant.example", "test")
                .stream()
                .filter(any::isFor))
        .isEmpty();
  }

  @Test
  void theCertificateThatIsMadeIsKeptWhereOnlyItsOwnerReadsIt() throws Exception {
    Path folder = dir.resolve("data/tls");
    PageAddress address = PageAddress.of(List.of("127.0.0.1", "cell-pc", "::1"));

    OwnCertificate made = OwnCertificate.in(folder, address);
    OwnCertificate again = OwnCertificate.in(folder, address);

    assertThat(made.isNew()).isTrue();
    assertThat(again.isNew()).isFalse();
    assertThat(again.certificate().fingerprint()).isEqualTo(made.certificate().fingerprint());
    assertThat(address.names()).allMatch(made.certificate()::isFor);
    assertThat(made.certificate().end())
        .isBetween(
            Instant.now().plus(Duration.ofDays(364)), Instant.now().plus(Duration.ofDays(366)));
    X509Certificate certificate =
        (X509Certificate) made.certificate().keyStore(PASSWORD).getCertificate("page");
    assertThat(certificate.getPublicKey().toString()).contains("256 bits", "secp256r1");
    try (var files = Files.list(folder)) {
      assertThat(files.map(it -> it.getFileName().toString())).containsExactly("page.pem");
    }
    assumeThat(Files.getFileStore(folder).supportsFileAttributeView("posix")).isTrue();
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(folder)))
        .isEqualTo("rwx------");
    assertThat(
            PosixFilePermissions.toString(
                Files.getPosixFilePermissions(folder.resolve("page.pem"))))
        .isEqualTo("rw-------");
  }

  @Test
  void aJavaWithoutKeytoolIsReported() {
    assertRefused(
        () -> OwnCertificate.in(dir.resolve("tls"), PageAddress.loopback(), dir),
        "this Java has no " + dir.resolve("bin"),
        "or a certificate of your own");
  }

  @Test
  void anotherCertificateIsMadeForAnotherNameAndBeforeTheEnd() throws Exception {
    Path folder = dir.resolve("tls");
    OwnCertificate first = OwnCertificate.in(folder, PageAddress.of(List.of("127.0.0.1")));

    OwnCertificate second =
        OwnCertificate.in(folder, PageAddress.of(List.of("127.0.0.1", "cell-pc")));
    Path old = keyStore(dir.resolve("a.p12"), "-keyalg", "EC", "-validity", "29");
    Files.writeString(
        folder.resolve("page.pem"), ServerCertificate.ofKeyStore(old, PASSWORD).pem());
    OwnCertificate third = OwnCertificate.in(folder, PageAddress.of(List.of("127.0.0.1")));

    assertThat(second.isNew()).isTrue();
    assertThat(second.certificate().fingerprint()).isNotEqualTo(first.certificate().fingerprint());
    assertThat(third.isNew()).isTrue();
  }
}
