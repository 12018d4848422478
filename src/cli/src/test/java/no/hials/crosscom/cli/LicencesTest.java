package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LicencesTest {
  @TempDir private Path dir;
  private Path texts;
  private Path output;

  @BeforeEach
  void createTexts() throws IOException {
    texts = Files.createDirectory(dir.resolve("texts"));
    output = dir.resolve("output");
    Files.writeString(texts.resolve("apache.txt"), "Apache\n  License");
    Files.writeString(
        texts.resolve("libraries.tsv"),
        """
        bare\tApache-2.0\thttps://bare.example\tapache.txt
        full-*\tApache-2.0\thttps://full.example\t-
        """);
  }

  private Path jar(String artifact, Map<String, String> entries) throws IOException {
    Path jar = dir.resolve("org/" + artifact + "/1.2/" + artifact + "-1.2.jar");
    Files.createDirectories(jar.getParent());
    try (ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(jar))) {
      for (Map.Entry<String, String> entry : new TreeMap<>(entries).entrySet()) {
        out.putNextEntry(new ZipEntry(entry.getKey()));
        out.write(entry.getValue().getBytes(StandardCharsets.UTF_8));
      }
    }
    return jar;
  }

  private Path bare() throws IOException {
    return jar("bare", Map.of("A.class", ""));
  }

  private Path full() throws IOException {
    return jar(
        "full-core",
        Map.of("META-INF/LICENSE", "Apache License", "META-INF/NOTICE.md", "by somebody"));
  }

  private void write(Path... jars) throws IOException {
    Licences.write(List.of(jars), texts, output);
  }

  @Test
  void listsEachLibraryWithItsTextsAndWritesEachTextOnce() throws Exception {
    Path ours = jar("jopenshowvar-lab", Map.of("META-INF/LICENSE", "ours"));

    write(bare(), full(), ours, dir);

    assertThat(output.resolve("NOTICE"))
        .content()
        .isEqualTo(
            """
            JOpenShowVar contains these libraries. The texts of their licences are in META-INF/licenses.

            bare 1.2
              licence: Apache-2.0
              home: https://bare.example
              texts: apache.txt

            full-core 1.2
              licence: Apache-2.0
              home: https://full.example
              texts: apache.txt, full-core-NOTICE.txt
            """);
    assertThat(output.resolve("licenses/full-core-NOTICE.txt")).hasContent("by somebody");
    assertThat(output.resolve("licenses")).isDirectoryNotContaining("glob:**full-core-LICENSE*");
  }

  @Test
  void aNewLibraryWithoutALineFailsTheBuild() {
    assertThatIllegalStateException()
        .isThrownBy(() -> write(bare(), full(), jar("added", Map.of("META-INF/LICENSE", "x"))))
        .withMessageEndingWith("libraries.tsv has no line for added");
  }

  @Test
  void aLibraryWithoutATextFailsTheBuild() {
    assertThatIllegalStateException()
        .isThrownBy(() -> write(bare(), jar("full-core", Map.of("A.class", ""))))
        .withMessageStartingWith("full-core has no text of its licence");
  }

  @Test
  void aLineWithoutALibraryFailsTheBuild() {
    assertThatIllegalStateException()
        .isThrownBy(() -> write(bare()))
        .withMessageEndingWith("full-* is not in the jar");
  }

  @Test
  void aTextThatIsNotThereFailsTheBuild() throws Exception {
    Files.delete(texts.resolve("apache.txt"));

    assertThatExceptionOfType(NoSuchFileException.class)
        .isThrownBy(() -> write(bare(), full()))
        .withMessageContaining("apache.txt");
  }
}
