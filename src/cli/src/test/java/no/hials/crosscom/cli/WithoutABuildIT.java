package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.Jar;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Uses the jar as docs/how-to/use-without-a-build.md describes. */
@Timeout(120)
class WithoutABuildIT {
  private static final Path JDK = Path.of(System.getProperty("java.home"), "bin");

  @TempDir private Path dir;
  @KukaController private MockServer server;

  @Test
  void jshellReadsAVariable() throws Exception {
    Path script = dir.resolve("script.jsh");
    Files.writeString(
        script,
        """
        import no.hials.crosscom.CrossComClient;
        CrossComClient client = new CrossComClient("%s", %d);
        System.out.println(client.readText("$MODE_OP"));
        client.close();
        /exit
        """
            .formatted(server.host(), server.port()));
    Cli.Result result =
        Jar.run(
            new ProcessBuilder(
                JDK.resolve("jshell").toString(),
                "--class-path",
                Jar.FILE.toString(),
                "-J-Djava.util.prefs.userRoot=" + dir,
                script.toString()),
            dir);

    // the JDK may report on stderr that it has created its preferences
    assertThat(result.lines()).as(result.err()).containsExactly("#T1");
  }

  @Test
  void aProgramOfOneFileRuns() throws Exception {
    Path program = dir.resolve("Hello.java");
    Files.writeString(
        program,
        """
        import no.hials.crosscom.CrossComClient;

        class Hello {
          public static void main(String[] args) throws Exception {
            try (CrossComClient client = new CrossComClient("%s", %d)) {
              System.out.println(client.readText("$MODE_OP"));
            }
          }
        }
        """
            .formatted(server.host(), server.port()));
    Jar.run(
            new ProcessBuilder(
                JDK.resolve("java").toString(),
                "--class-path",
                Jar.FILE.toString(),
                program.toString()),
            dir)
        .succeeds()
        .containsExactly("#T1");
  }
}
