package no.hials.crosscom.cell;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class AuditLogTest {
  @TempDir private Path folder;
  private Path file;
  private AuditLog audit;

  @BeforeEach
  void create() {
    file = folder.resolve("audit.jsonl");
    audit = new AuditLog(folder);
  }

  private static void write(AuditLog log, String value) {
    log.add(new AuditLog.Entry("test", "mock", "write", "MYINT", "1", value, "done"));
  }

  private List<String> lines() throws IOException {
    return Files.readAllLines(file);
  }

  @Test
  void theFirstLineAfterAFailureSaysHowManyAreMissing() throws Exception {
    List<String> heard = new ArrayList<>();
    audit.addListener(heard::add);
    write(audit, "2");
    byte[] before = Files.readAllBytes(file);
    Files.delete(file);
    Files.createDirectory(file); // takes no line

    write(audit, "3");
    write(audit, "4");
    assertThat(audit.failure()).contains("directory");
    Files.delete(file);
    Files.write(file, before);
    write(audit, "5");
    write(audit, "6");

    assertThat(audit.failure()).isEmpty();
    assertThat(lines())
        .satisfiesExactly(
            line -> assertThat(line).contains("\"after\":\"2\""),
            line ->
                assertThat(line)
                    .contains("\"what\":\"audit\",\"name\":\"audit.jsonl\"")
                    .contains("\"result\":\"2 lines are missing before this one: "),
            line -> assertThat(line).contains("\"after\":\"5\""),
            line -> assertThat(line).contains("\"after\":\"6\""));
    assertThat(heard).hasSize(6).isEqualTo(audit.recent());
  }

  @Test
  void aLineDoesNotContinueTheHalfOneOfAKilledProcess() throws Exception {
    Files.writeString(file, "{\"time\":\"20");

    write(audit, "2");
    write(audit, "3");

    assertThat(lines())
        .satisfiesExactly(
            line -> assertThat(line).isEqualTo("{\"time\":\"20"),
            line -> assertThat(line).startsWith("{\"time\":").contains("\"after\":\"2\""),
            line -> assertThat(line).startsWith("{\"time\":").contains("\"after\":\"3\""));
  }

  /** Writes lines until the first that fails, in a process of its own. */
  static final class UntilItFails {
    private UntilItFails() {}

    public static void main(String[] arguments) {
      AuditLog log = new AuditLog(Path.of(arguments[0]));
      for (int i = 0; log.failure().isEmpty(); i++) {
        write(log, String.valueOf(i));
      }
      System.out.println("failed: " + log.failure());
    }
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void aDiskThatTakesHalfALineIsLeftWithWholeLines() throws Exception {
    Process process =
        new ProcessBuilder(
                "sh",
                "-c",
                "ulimit -f 2; exec \"$@\"", // the largest file, in blocks
                "sh",
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:-UsePerfData",
                "-cp",
                System.getProperty(
                    "surefire.test.class.path", System.getProperty("java.class.path")),
                UntilItFails.class.getName(),
                folder.toString())
            .redirectErrorStream(true)
            .start();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).as(output).isZero();
    assertThat(output).contains("failed: File too large");

    assertThat(Files.readString(file)).endsWith("}\n");
    assertThat(lines()).isNotEmpty().allSatisfy(line -> assertThat(line).endsWith("\"}"));
  }
}
