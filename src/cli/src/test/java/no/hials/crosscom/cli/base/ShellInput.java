package no.hials.crosscom.cli.base;

import java.io.StringReader;
import java.io.StringWriter;
import java.util.Arrays;
import java.util.Map;
import no.hials.crosscom.cli.Main;
import no.hials.crosscom.mock.MockServer;
import org.jspecify.annotations.Nullable;

/** Runs the command line inside the tests' JVM with lines on its stdin. */
public final class ShellInput {
  private ShellInput() {}

  public static Cli.Result runOn(MockServer server, String input, String... args) {
    String[] options = Arrays.copyOfRange(args, 1, args.length);
    return run(input, null, Cli.argsOn(server, args[0], options));
  }

  /**
   * Runs it.
   *
   * @param questions answers questions; null if there is nobody to do that
   */
  public static Cli.Result run(String input, Console.@Nullable Prompt questions, String... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    Console console = new Console(out, err, Map.of(), new StringReader(input), questions);
    int code = Main.run(args, console);
    return new Cli.Result(code, out.toString(), err.toString());
  }
}
