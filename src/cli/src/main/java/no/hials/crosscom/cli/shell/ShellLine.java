package no.hials.crosscom.cli.shell;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import no.hials.crosscom.cell.ValueText;
import no.hials.crosscom.cli.base.Converters;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.Suggestions;
import picocli.CommandLine.TypeConversionException;

/** A parsed line of the shell language; the same for typed lines, pipes and files. */
sealed interface ShellLine {

  /** The words of the language itself, with their syntax and effect. */
  Map<String, BuiltIn> BUILT_INS =
      Map.ofEntries(
          Map.entry("get", new BuiltIn("get NAME...", "reads variables; also read")),
          Map.entry("set", new BuiltIn("set NAME VALUE", "writes a variable; also write")),
          Map.entry("wait", new BuiltIn("wait TIME", "waits: 500, 500ms, 3s, 1m")),
          Map.entry("help", new BuiltIn("help [NAME|COMMAND]", "explains a variable or a command")),
          Map.entry("exit", new BuiltIn("exit, quit, Ctrl-D", "ends the shell")));

  /**
   * Executes the line.
   *
   * @return the exit code; the caller handles the end of the shell
   */
  ExitCode run(ShellSession session) throws IOException;

  /**
   * A command that only the shell has.
   *
   * @param synopsis its name and parameters
   * @param help what it does
   */
  record BuiltIn(String synopsis, String help) {
    /** Returns the line of the shell's help. */
    String line() {
      return "%-20s %s".formatted(synopsis, help);
    }
  }

  /** A blank line or a comment. */
  record Nothing() implements ShellLine {
    @Override
    public ExitCode run(ShellSession session) throws IOException {
      return ExitCode.DONE;
    }
  }

  /**
   * Reads variables.
   *
   * @param names at least one
   */
  record Read(List<String> names) implements ShellLine {
    @Override
    public ExitCode run(ShellSession session) throws IOException {
      session.read(names);
      return ExitCode.DONE;
    }

    @Override
    public String toString() {
      return "read " + String.join(" ", names);
    }
  }

  /**
   * Writes a variable.
   *
   * @param name its name
   * @param value the value as it was typed, a KRL value
   */
  record Write(String name, String value) implements ShellLine {
    @Override
    public ExitCode run(ShellSession session) throws IOException {
      session.write(this);
      return ExitCode.DONE;
    }

    @Override
    public String toString() {
      return "write " + name + " = " + value;
    }
  }

  /**
   * Waits.
   *
   * @param time the duration
   */
  record Wait(Duration time) implements ShellLine {
    @Override
    public ExitCode run(ShellSession session) throws IOException {
      ShellSession.sleep(time);
      return ExitCode.DONE;
    }

    @Override
    public String toString() {
      return "wait " + time.toMillis() + " ms";
    }
  }

  /**
   * Explains something.
   *
   * @param topic a variable or a command; empty for the language
   */
  record Help(String topic) implements ShellLine {
    @Override
    public ExitCode run(ShellSession session) throws IOException {
      session.help(topic);
      return ExitCode.DONE;
    }

    @Override
    public String toString() {
      return topic.isEmpty() ? "help" : "help " + topic;
    }
  }

  /** Ends the shell. */
  record Exit() implements ShellLine {
    @Override
    public ExitCode run(ShellSession session) throws IOException {
      return ExitCode.DONE;
    }

    @Override
    public String toString() {
      return "exit";
    }
  }

  /**
   * Runs another command of the command line.
   *
   * @param words the command and its arguments
   */
  record Command(List<String> words) implements ShellLine {
    @Override
    public ExitCode run(ShellSession session) throws IOException {
      return session.run(words);
    }

    @Override
    public String toString() {
      return String.join(" ", words);
    }
  }

  /**
   * Parses a line.
   *
   * @param commands the names of the commands of the command line
   * @throws ShellSyntaxException if the line is not in the language
   */
  static ShellLine parse(String line, Set<String> commands) throws ShellSyntaxException {
    // a file may begin with a byte order mark, and files put together have one further down
    List<String> words = ShellWords.split(line.startsWith("\ufeff") ? line.substring(1) : line);
    if (words.isEmpty()) {
      return new Nothing();
    }
    String first = canonical(words.get(0));
    List<String> rest = words.subList(1, words.size());
    return switch (first) {
      case "get" -> new Read(names(rest));
      case "set" -> write(first, rest);
      case "wait" -> new Wait(time(only(first, rest)));
      case "help" -> new Help(rest.isEmpty() ? "" : only(first, rest));
      case "drive", "mock", "run", "shell" ->
          throw new ShellSyntaxException(first + " is not available in the shell");
      case "exit" -> {
        nothingBehind(first, rest);
        yield new Exit();
      }
      default -> commands.contains(first) ? command(first, rest) : variable(words, commands);
    };
  }

  /** Returns a command in lower case; if it has two names, the name in {@link #BUILT_INS}. */
  static String canonical(String word) {
    String lower = word.toLowerCase(Locale.ROOT);
    return switch (lower) {
      case "read" -> "get";
      case "write" -> "set";
      case "quit" -> "exit";
      default -> lower;
    };
  }

  private static ShellLine command(String name, List<String> rest) {
    List<String> words = new ArrayList<>(rest.size() + 1);
    words.add(name);
    rest.forEach(word -> words.add(ShellWords.unquoted(word)));
    return new Command(List.copyOf(words));
  }

  private static ShellLine variable(List<String> words, Set<String> commands)
      throws ShellSyntaxException {
    boolean sign = words.size() > 1 && words.get(1).equals("=");
    if (!sign) {
      checkNoTypingMistake(words.get(0), commands);
    }
    if (words.size() == 1) {
      return new Read(names(words));
    }
    return write("", words);
  }

  /**
   * Refuses a word that is nearly a command, so that it is not read or written as a variable.
   * Commands are typed in lower case; a word with a capital, a digit or {@code $} is a variable.
   */
  private static void checkNoTypingMistake(String word, Set<String> commands)
      throws ShellSyntaxException {
    if (word.matches("[a-z]+")) {
      Set<String> all = new TreeSet<>(commands);
      all.addAll(BUILT_INS.keySet());
      all.addAll(List.of("read", "write", "quit"));
      List<String> meant = Suggestions.near(word, all);
      if (!meant.isEmpty()) {
        throw new ShellSyntaxException(
            "unknown command: "
                + word
                + "; "
                + Suggestions.question(meant)
                + " For a variable of this name: get "
                + word
                + ", set "
                + word
                + " VALUE");
      }
    }
  }

  /** Creates a write of {@code NAME VALUE} or {@code NAME = VALUE}. */
  private static ShellLine write(String command, List<String> words) throws ShellSyntaxException {
    boolean sign = words.size() > 1 && words.get(1).equals("=");
    List<String> value = words.size() > 1 ? words.subList(sign ? 2 : 1, words.size()) : List.of();
    if (value.isEmpty()) {
      String form = command.isEmpty() ? "NAME = VALUE" : command + " NAME VALUE";
      throw new ShellSyntaxException("the value is missing: " + form);
    }
    String name = name(words.get(0));
    String text = String.join(" ", value);
    try {
      ValueText.parse(name, text, "");
    } catch (IllegalArgumentException e) {
      String what = text + " " + e.getMessage();
      throw new ShellSyntaxException(
          command.isEmpty() && !sign ? "unknown command: " + name + "; as a write: " + what : what);
    }
    return new Write(name, text);
  }

  private static List<String> names(List<String> words) throws ShellSyntaxException {
    if (words.isEmpty()) {
      throw new ShellSyntaxException("missing names of variables: get NAME...");
    }
    for (String word : words) {
      name(word);
    }
    return List.copyOf(words);
  }

  private static String name(String word) throws ShellSyntaxException {
    if (!ShellWords.isName(word)) {
      throw new ShellSyntaxException(
          "must be a variable, such as $OV_PRO, $POS_ACT.X or MYTEXT[], is " + word);
    }
    return word;
  }

  private static Duration time(String word) throws ShellSyntaxException {
    try {
      return new Converters.Time().convert(word);
    } catch (TypeConversionException e) {
      throw new ShellSyntaxException("the time to wait " + e.getMessage());
    }
  }

  private static String only(String command, List<String> rest) throws ShellSyntaxException {
    if (rest.size() != 1) {
      throw new ShellSyntaxException(command + " needs one argument, has " + rest.size());
    }
    return rest.get(0);
  }

  private static void nothingBehind(String command, List<String> rest) throws ShellSyntaxException {
    if (!rest.isEmpty()) {
      throw new ShellSyntaxException(command + " takes no argument, has " + String.join(" ", rest));
    }
  }
}
