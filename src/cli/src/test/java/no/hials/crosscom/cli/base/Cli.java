package no.hials.crosscom.cli.base;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Stream;
import no.hials.crosscom.cli.Main;
import no.hials.crosscom.mock.MockServer;
import org.assertj.core.api.AbstractStringAssert;
import org.assertj.core.api.ListAssert;

/** Runs the command line inside the tests' JVM, with captured streams. */
public final class Cli {
  /** Where the configuration file would lie, on Windows and elsewhere. */
  private static final Map<String, String> NO_CONFIGURATION =
      Map.of(
          "XDG_CONFIG_HOME", Path.of("target", "no-configuration").toAbsolutePath().toString(),
          "APPDATA", Path.of("target", "no-configuration").toAbsolutePath().toString());

  private Cli() {}

  /** The result of a run. */
  public record Result(int code, String out, String err) {
    public List<String> lines() {
      return out.lines().toList();
    }

    public List<String> errLines() {
      return err.lines().toList();
    }

    /** Checks that the exit code is 0 and stderr is empty. Returns the lines of stdout to check. */
    public ListAssert<String> succeeds() {
      assertThat(err).isEmpty();
      assertThat(code).isZero();
      return assertThat(lines());
    }

    /** Checks the exit code, and that stdout is empty. Returns stderr to check. */
    public AbstractStringAssert<?> fails(int expected) {
      assertThat(code).as(err).isEqualTo(expected);
      assertThat(out).isEmpty();
      return assertThat(err);
    }

    /** As {@link #fails}, but returns the lines of stderr. */
    public ListAssert<String> failsInLines(int expected) {
      fails(expected);
      return assertThat(errLines());
    }

    /** As {@link #fails}, but stderr must be one line, which it returns. */
    public AbstractStringAssert<?> failsInALine(int expected) {
      return failsInLines(expected).singleElement().asString();
    }
  }

  /** Runs it without what the user who runs the tests has in environment and configuration. */
  public static Result run(String... args) {
    return runIn(Map.of(), args);
  }

  /** Runs it with these environment variables, and no others. */
  public static Result runIn(Map<String, String> environment, String... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    Map<String, String> all = new HashMap<>(NO_CONFIGURATION);
    all.putAll(environment);
    int code = Main.run(args, new Console(out, err, all));
    return new Result(code, out.toString(), err.toString());
  }

  /** Runs it with a stdout that is closed already, and returns the exit code. */
  public static int runUnread(String... args) throws IOException {
    Writer out = Writer.nullWriter();
    out.close();
    return Main.run(args, new Console(out, new StringWriter(), NO_CONFIGURATION));
  }

  public static Result runOn(MockServer server, String command, String... args) {
    return run(argsOn(server, command, args));
  }

  /**
   * Returns the arguments for a server; a command may be {@code file ls}. The options come first,
   * so that anything may follow.
   */
  public static String[] argsOn(MockServer server, String command, String... args) {
    Stream<String> options =
        Stream.of("--host", server.host(), "--port", Integer.toString(server.port()));
    return Stream.of(Stream.of(command.split(" ")), options, Stream.of(args))
        .flatMap(Function.identity())
        .toArray(String[]::new);
  }
}
