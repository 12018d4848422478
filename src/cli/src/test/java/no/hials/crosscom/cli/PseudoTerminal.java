package no.hials.crosscom.cli;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Runs the jar on a terminal, which {@code script} of util-linux makes. */
final class PseudoTerminal {
  static final String CTRL_C = "\u0003";
  static final String CTRL_D = "\u0004";

  private static final Path SCRIPT = Path.of("/usr/bin/script");
  private static final int SIGINT_BIT = 1 << 1;

  private PseudoTerminal() {}

  static boolean isAvailable() {
    return Files.isExecutable(SCRIPT);
  }

  /** Says whether Ctrl-C ends what runs here: a shell's background jobs do not take it. */
  static boolean takesCtrlC() throws IOException {
    String ignored =
        Files.readAllLines(Path.of("/proc/self/status")).stream()
            .filter(line -> line.startsWith("SigIgn:"))
            .findFirst()
            .orElseThrow()
            .substring("SigIgn:".length())
            .strip();
    return (Long.parseUnsignedLong(ignored, 16) & SIGINT_BIT) == 0;
  }

  /**
   * What was shown.
   *
   * @param code the exit code
   * @param text all that came, with the echo of what was typed
   */
  record Shown(int code, String text) {}

  /**
   * Runs a command until it ends.
   *
   * @param term the kind of the terminal
   * @param until a text, after which the keys are pressed
   */
  static Shown run(String term, String until, String keys, String... args)
      throws IOException, InterruptedException {
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    String command =
        Stream.concat(Stream.of(java, "-jar", "target/jopenshowvar.jar"), Stream.of(args))
            .map(arg -> "'" + arg + "'")
            .collect(Collectors.joining(" ", "exec ", ""));
    ProcessBuilder builder = new ProcessBuilder(SCRIPT.toString(), "-qec", command, "/dev/null");
    builder.environment().keySet().removeAll(List.of("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS"));
    builder.environment().put("TERM", term);
    builder.redirectErrorStream(true);
    Process process = builder.start();
    try {
      String shown = type(process, until, keys);
      return new Shown(process.waitFor(), shown);
    } finally {
      process.destroyForcibly();
    }
  }

  private static String type(Process process, String until, String keys) throws IOException {
    StringBuilder shown = new StringBuilder();
    InputStream terminal = process.getInputStream();
    byte[] bytes = new byte[1000];
    boolean pressed = false;
    int length = terminal.read(bytes);
    while (length > 0) {
      shown.append(new String(bytes, 0, length, StandardCharsets.ISO_8859_1));
      if (!pressed && shown.indexOf(until) >= 0) {
        pressed = true;
        process.getOutputStream().write(keys.getBytes(StandardCharsets.ISO_8859_1));
        process.getOutputStream().flush();
      }
      length = terminal.read(bytes);
    }
    return shown.toString();
  }
}
