package no.hials.crosscom.gateway.internal.opcua;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.cert.X509Certificate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The own certificate, when its file was not written in whole. */
class PkiTest {
  @TempDir private Path folder;

  private X509Certificate certificate() throws IOException {
    try (Pki pki = Pki.open(folder, "localhost")) {
      return pki.certificate();
    }
  }

  @Test
  void anUnfinishedFileOfTheCertificateIsReplaced() throws Exception {
    Path part = Files.createDirectories(folder.resolve("own")).resolve("gateway.p12.part");
    Files.writeString(part, "as a full disk leaves it");

    X509Certificate created = certificate();

    assertThat(part).doesNotExist();
    assertThat(certificate()).isEqualTo(created);
  }

  @Test
  void aFailureLeavesNoFileThatPreventsTheNextStart() throws Exception {
    Path part = folder.resolve("own").resolve("gateway.p12.part");
    Path inTheWay = Files.createDirectories(part.resolve("folder"));
    assertThatThrownBy(this::certificate).isInstanceOf(IOException.class);

    Files.delete(inTheWay);

    assertThat(certificate()).isEqualTo(certificate());
  }

  @Test
  void aDamagedFileOfTheCertificateIsNamed() throws Exception {
    Path store = Files.createDirectories(folder.resolve("own")).resolve("gateway.p12");
    Files.writeString(store, "");

    assertThatThrownBy(this::certificate)
        .hasMessageContaining(store + " cannot be read")
        .hasMessageContaining("creates another certificate");
  }
}
