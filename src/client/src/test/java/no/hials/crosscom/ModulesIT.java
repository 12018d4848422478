package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.spi.ToolProvider;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.Codec;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.slf4j.Logger;

/** A program that is a module, with the jars of client, protocol and slf4j as modules. */
class ModulesIT {
  @TempDir private static Path folder;

  private static String modulePath;

  @BeforeAll
  static void compileAProgram() throws Exception {
    Path source = Files.createDirectories(folder.resolve("source/app"));
    Path declaration =
        Files.writeString(
            folder.resolve("source/module-info.java"),
            "module app { requires no.hials.crosscom; }");
    Path program =
        Files.writeString(
            source.resolve("Main.java"),
            """
            package app;

            import no.hials.crosscom.CrossComClient;
            import no.hials.crosscom.KRL.KRLInt;

            public class Main {
              public static void main(String... args) throws Exception {
                try (CrossComClient client =
                    new CrossComClient(args[0], Integer.parseInt(args[1]))) {
                  KRLInt override = new KRLInt("$OV_PRO");
                  client.readVariable(override);
                  System.out.println("$OV_PRO = " + override.intValue());
                }
              }
            }
            """);
    Path classes = folder.resolve("classes");
    String jars =
        Stream.of(CrossComClient.class, Codec.class, Logger.class)
            .map(ModulesIT::jar)
            .collect(Collectors.joining(File.pathSeparator));
    modulePath = classes + File.pathSeparator + jars;
    run("javac", "-d", classes, "--module-path", jars, declaration, program);
  }

  private static String jar(Class<?> type) {
    try {
      return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
    } catch (URISyntaxException e) {
      throw new AssertionError(e);
    }
  }

  private static void run(String tool, Object... args) {
    StringWriter shown = new StringWriter();
    PrintWriter out = new PrintWriter(shown);

    int code =
        ToolProvider.findFirst(tool)
            .orElseThrow()
            .run(out, out, Arrays.stream(args).map(Object::toString).toArray(String[]::new));

    assertThat(code).as("%s: %s", tool, shown).isZero();
  }

  @Test
  void aProgramRunsOnTheModulePath() throws Exception {
    assertReads(Path.of(System.getProperty("java.home")), "--module-path", modulePath);
  }

  @Test
  void aProgramRunsInAnImageOfJlink() throws Exception {
    Path image = folder.resolve("image");
    run("jlink", "--module-path", modulePath, "--add-modules", "app", "--output", image);

    assertReads(image);
  }

  private static void assertReads(Path java, String... options)
      throws IOException, InterruptedException {
    try (MockServer server = MockServer.start()) {
      List<String> command =
          Stream.of(
                  Stream.of(java.resolve("bin/java").toString()),
                  Stream.of(options),
                  Stream.of("-m", "app/app.Main", server.host(), String.valueOf(server.port())))
              .flatMap(args -> args)
              .toList();
      Path errors = folder.resolve("errors.txt");
      Process process = new ProcessBuilder(command).redirectError(errors.toFile()).start();
      String shown = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

      assertThat(process.waitFor()).as(Files.readString(errors)).isZero();
      assertThat(shown).isEqualToIgnoringNewLines("$OV_PRO = 100");
    }
  }
}
