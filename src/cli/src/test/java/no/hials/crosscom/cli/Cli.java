package no.hials.crosscom.cli;

import java.io.StringWriter;
import java.util.List;
import java.util.stream.Stream;
import no.hials.crosscom.mock.MockServer;

/** Runs the command line inside the tests' JVM, with captured streams. */
final class Cli {
  private Cli() {}

  /** What a run gave. */
  record Result(int code, String out, String err) {
    List<String> lines() {
      return out.lines().toList();
    }

    List<String> errLines() {
      return err.lines().toList();
    }
  }

  static Result run(String... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int code = Main.run(args, out, err);
    return new Result(code, out.toString(), err.toString());
  }

  static Result runOn(MockServer server, String command, String... args) {
    return run(argsOn(server, command, args));
  }

  /** Gives the arguments for a server. The options come first, so that anything may follow. */
  static String[] argsOn(MockServer server, String command, String... args) {
    Stream<String> options =
        Stream.of(command, "--host", server.host(), "--port", Integer.toString(server.port()));
    return Stream.concat(options, Stream.of(args)).toArray(String[]::new);
  }
}
