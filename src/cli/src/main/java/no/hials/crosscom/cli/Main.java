package no.hials.crosscom.cli;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.OutputStreamWriter;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.Writer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import no.hials.crosscom.cell.recording.OutputException;
import no.hials.crosscom.cli.base.CommandTree;
import no.hials.crosscom.cli.base.Console;
import no.hials.crosscom.cli.base.ConsoleCommand;
import no.hials.crosscom.cli.base.ControllerCommand;
import no.hials.crosscom.cli.base.Converters;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.StopSignal;
import no.hials.crosscom.cli.base.Suggestions;
import no.hials.crosscom.cli.bridge.BridgeCommand;
import no.hials.crosscom.protocol.ServerType;
import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/** Runs {@code jopenshowvar}, the command line. */
public final class Main {
  /** The commands for usual words of other programs. */
  private static final Map<String, String> SYNONYMS =
      Map.of(
          "get", "read",
          "set", "write",
          "cat", "file get",
          "delete", "file rm",
          "list", "file ls",
          "dir", "file ls",
          "upload", "file put",
          "download", "file get");

  private Main() {}

  /**
   * Runs the command line on the streams of the process, and ends the process.
   *
   * @param args the arguments
   */
  public static void main(String... args) {
    Writer out = writer(FileDescriptor.out, "stdout.encoding");
    Writer err = writer(FileDescriptor.err, "stderr.encoding");
    StopSignal.exit(run(args, out, err));
  }

  /**
   * Runs the command line.
   *
   * @param args the arguments
   * @param out receives the data
   * @param err receives everything else
   * @return the exit code
   */
  public static int run(String[] args, Writer out, Writer err) {
    return run(args, new Console(out, err, System.getenv()));
  }

  public static int run(String[] args, Console console) {
    try {
      int robots = (int) Arrays.stream(args).takeWhile(ControllerCommand::isRobot).count();
      String[] rest = Arrays.copyOfRange(args, robots, args.length);
      CommandLine main = commandLine(console, rest);
      StringWriter help = new StringWriter();
      main.setOut(new PrintWriter(help));
      int code = main.execute(arguments(main, Arrays.copyOf(args, robots), rest));
      if (help.getBuffer().length() > 0) {
        console.write(help.toString());
      }
      return code;
    } catch (ParameterException e) {
      return usageError(console, e, args).code();
    } catch (OutputException e) {
      return failure(console, e, false).code();
    } catch (Error e) {
      return internalError(console, e, true).code();
    }
  }

  /**
   * Returns the arguments with the robots that stand before the command after it, as options.
   *
   * @throws ParameterException if there are robots in both places
   */
  private static String[] arguments(CommandLine main, String[] robots, String... rest) {
    List<String> all = new ArrayList<>(List.of(ControllerCommand.withNamesAsOptions(rest)));
    int words = CommandTree.depth(CommandTree.find(main, rest));
    boolean isHelp = rest.length > 0 && rest[0].equals("help"); // the robot does not matter
    if (robots.length > 0 && words > 0 && !isHelp) {
      if (all.stream().takeWhile(arg -> !arg.equals("--")).anyMatch(a -> a.startsWith("--robot"))) {
        throw new ParameterException(
            main,
            robots[0] + " stands before the command, and another robot after it; use one place");
      }
      all.addAll(words, List.of(ControllerCommand.withNamesAsOptions(robots)));
    }
    return all.toArray(String[]::new);
  }

  /** Creates the tree of commands: all commands, or only those in the arguments. */
  public static CommandLine commandLine(Console console, String... args) {
    CommandLine main = new CommandLine(new MainCommand(console));
    Commands.addTo(main, args);
    Handlers handlers = new Handlers(console);
    return main.registerConverter(Duration.class, new Converters.Time())
        .registerConverter(ServerType.class, new Converters.ServerName())
        .registerConverter(Long.class, new Converters.WholeNumber())
        .registerConverter(long.class, new Converters.WholeNumber())
        .registerConverter(Integer.class, new Converters.SmallNumber())
        .registerConverter(int.class, new Converters.SmallNumber())
        .registerConverter(Double.class, new Converters.AnyNumber())
        // an argument @NAME is not a file with arguments
        .setExpandAtFiles(false)
        .setOut(console.out())
        .setErr(console.err())
        .setParameterExceptionHandler(handlers)
        .setExecutionExceptionHandler(handlers);
  }

  /** Not two lambdas, which a class data archive cannot hold for picocli's old interfaces. */
  private record Handlers(Console console)
      implements IParameterExceptionHandler, IExecutionExceptionHandler {
    @Override
    public int handleParseException(ParameterException e, String[] args) {
      return usageError(console, e, args).code();
    }

    @Override
    public int handleExecutionException(Exception e, CommandLine command, ParseResult parsed) {
      boolean verbose = command.getCommand() instanceof ConsoleCommand own && own.isVerbose();
      return failure(console, e, verbose).code();
    }
  }

  private static ExitCode usageError(Console console, ParameterException e, String... args) {
    CommandLine command = e.getCommandLine();
    Set<String> subcommands = command.getSubcommands().keySet();
    // picocli has no class of its own for a missing subcommand
    boolean isSubcommandMissing =
        e.getClass() == ParameterException.class && !subcommands.isEmpty();
    console.error(
        ConsoleCommand.message(e)
            + (isSubcommandMissing ? ": " + String.join(", ", subcommands) : ""));
    if (e instanceof MissingParameterException missing
        && missing.getMissing().stream().anyMatch(ArgSpec::isPositional)
        && e.getCommandLine().getCommand() instanceof ControllerCommand) {
      if (Arrays.stream(args).anyMatch(arg -> arg.matches("-[^A-Za-z-].*"))) {
        console.hint("a value that begins with - must be a number, such as -1.5");
      } else if (!(e.getCommandLine().getCommand() instanceof BridgeCommand)) {
        console.hint("in a shell, names with $ need single quotes: '$OV_PRO'");
      }
    }
    if (e instanceof UnmatchedArgumentException unmatched) {
      String typed = unmatched.getUnmatched().get(0);
      String question = Suggestions.question(suggestions(console, command, typed));
      if (!question.isEmpty()) {
        console.hint(question);
      }
    }
    console.hint("try '" + command.getCommandSpec().qualifiedName() + " --help'");
    return ExitCode.USAGE;
  }

  /** Returns the options, or the commands, that a mistyped one may stand for. */
  private static List<String> suggestions(Console console, CommandLine command, String typed) {
    if (typed.startsWith("-")) {
      return Suggestions.of(
          typed.replaceFirst("=.*", ""),
          command.getCommandSpec().optionsMap().keySet().stream()
              .filter(name -> name.startsWith("--"))
              .toList());
    }
    Set<String> words = command.getSubcommands().keySet();
    List<String> elsewhere = words.isEmpty() ? List.of() : elsewhere(console, typed);
    return elsewhere.isEmpty() ? Suggestions.of(typed, words) : elsewhere;
  }

  /** Returns the commands that a word stands for in another place, or in other programs. */
  private static List<String> elsewhere(Console console, String typed) {
    CommandSpec program = commandLine(console).getCommandSpec();
    Stream<String> same =
        CommandTree.withAllBelow(program)
            .filter(each -> each.name().equals(typed))
            .map(each -> each.qualifiedName().substring(program.name().length() + 1));
    return Stream.concat(Stream.ofNullable(SYNONYMS.get(typed)), same).toList();
  }

  private static ExitCode failure(Console console, Exception e, boolean verbose) {
    ExitCode code = ExitCode.of(e);
    if (code == ExitCode.INTERNAL_ERROR) {
      return internalError(console, e, verbose);
    }
    // the reader of the output has closed it, as head does after some lines
    if (!(e instanceof OutputException lost && lost.isBrokenPipe())) {
      console.failure(e, verbose);
    }
    return code;
  }

  private static ExitCode internalError(Console console, Throwable e, boolean verbose) {
    console.error("internal error: " + e);
    if (verbose) {
      console.trace(e);
    } else {
      console.hint("--verbose prints the stack trace");
    }
    return ExitCode.INTERNAL_ERROR;
  }

  /**
   * Creates a writer that, unlike System.out, throws an exception when it cannot write.
   *
   * @param encoding see {@link Console#charset}
   */
  private static Writer writer(FileDescriptor to, String encoding) {
    return new OutputStreamWriter(new FileOutputStream(to), Console.charset(encoding));
  }
}
