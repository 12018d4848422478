package no.hials.crosscom.web;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Key stores as other people make them: by the {@code keytool} of this JDK. */
final class TestCertificates {
  static final char[] PASSWORD = "secret word".toCharArray();

  private TestCertificates() {}

  /** Creates a key store for 127.0.0.1 and cell.example, with further arguments of keytool. */
  static Path keyStore(Path file, String... more) throws IOException, InterruptedException {
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "keytool").toString(),
                "-genkeypair",
                "-alias",
                "a",
                "-dname",
                "CN=test",
                "-ext",
                "san=ip:127.0.0.1,dns:cell.example,dns:*.plant.example",
                "-keystore",
                file.toString(),
                "-storepass",
                new String(PASSWORD)));
    command.addAll(List.of(more.length > 0 ? more : new String[] {"-keyalg", "EC"}));
    Process process =
        new ProcessBuilder(command)
            .redirectErrorStream(true)
            .redirectOutput(file.resolveSibling("keytool.txt").toFile())
            .start();
    if (process.waitFor() != 0) {
      throw new AssertionError(String.join(" ", command));
    }
    return file;
  }
}
