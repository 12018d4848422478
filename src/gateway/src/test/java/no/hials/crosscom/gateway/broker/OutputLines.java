package no.hials.crosscom.gateway.broker;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A running program whose output is read to the end, so that the program never blocks on it. */
final class OutputLines implements AutoCloseable {
  private final Process process;
  private final BufferedReader reader;
  private final StringBuilder seen = new StringBuilder();

  private OutputLines(Process process) {
    this.process = process;
    this.reader = process.inputReader();
  }

  /** Starts a program. */
  static OutputLines of(ProcessBuilder builder) throws IOException {
    return new OutputLines(builder.redirectErrorStream(true).start());
  }

  /** Reads up to the first line that contains a pattern, and returns its first group. */
  String await(Pattern pattern) throws IOException {
    String line;
    while ((line = reader.readLine()) != null) {
      seen.append(line).append('\n');
      Matcher matcher = pattern.matcher(line);
      if (matcher.find()) {
        Thread rest = new Thread(this::readToTheEnd, "output");
        rest.setDaemon(true);
        rest.start();
        return matcher.group(1);
      }
    }
    throw new AssertionError("ended without " + pattern + ":\n" + seen);
  }

  private void readToTheEnd() {
    try {
      while (reader.readLine() != null) {
        // only keeps the program from blocking
      }
    } catch (IOException e) {
      if (process.isAlive()) {
        throw new UncheckedIOException(e);
      }
    }
  }

  @Override
  public void close() {
    process.destroyForcibly().onExit().join();
  }
}
