package no.hials.crosscom.cli.base;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** Runs the built jar in a process of its own. */
public final class Jar {
  public static final Path FILE = Path.of("target", "jopenshowvar.jar");

  private Jar() {}

  /**
   * Returns the command to start, with the options of Java that the start script takes for commands
   * that end at once.
   */
  static List<String> command(String... args) {
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    return Stream.concat(
            Stream.of(java, "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-XX:-UsePerfData"),
            Stream.concat(Stream.of("-jar", FILE.toString()), Stream.of(args)))
        .toList();
  }

  /** Returns the process to start, without the environment of the user who runs the tests. */
  public static ProcessBuilder process(String... args) {
    ProcessBuilder builder = new ProcessBuilder(new ArrayList<>(command(args)));
    // the JVM says on stderr that it found them
    builder.environment().keySet().removeAll(List.of("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS"));
    builder.environment().keySet().removeIf(name -> name.startsWith("JOPENSHOWVAR_"));
    builder.environment().put("XDG_CONFIG_HOME", FILE.resolveSibling("none").toAbsolutePath() + "");
    return builder;
  }

  /** Lets a signal through also where the build ignores it, by {@code env} of coreutils. */
  public static ProcessBuilder withDefaultSignal(String signal, ProcessBuilder builder) {
    builder.command().addAll(0, List.of("env", "--default-signal=" + signal));
    return builder;
  }

  /** Sends a signal to a process. */
  public static void send(String signal, Process process) throws IOException, InterruptedException {
    assertThat(new ProcessBuilder("kill", "-" + signal, "" + process.pid()).start().waitFor())
        .isZero();
  }

  /** Runs a process until it ends, with stdout and stderr in files of the folder. */
  public static Cli.Result run(ProcessBuilder builder, Path folder)
      throws IOException, InterruptedException {
    Path out = folder.resolve("out");
    Path err = folder.resolve("err");
    Process process = builder.redirectOutput(out.toFile()).redirectError(err.toFile()).start();
    try {
      int code = process.waitFor();
      return new Cli.Result(code, Files.readString(out), Files.readString(err));
    } finally {
      process.destroyForcibly();
    }
  }
}
