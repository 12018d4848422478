package no.hials.crosscom.cli.base;

import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.io.Reader;
import java.io.Writer;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.WritePermission;
import no.hials.crosscom.cell.recording.OutputException;
import no.hials.crosscom.control.input.TypedKeys;
import no.hials.crosscom.protocol.value.PrintableText;
import org.jspecify.annotations.Nullable;

/**
 * The output of a command: data to one stream, messages to another. Both are flushed line by line,
 * so that their lines are in order if both go to the same terminal.
 */
public final class Console implements WritePermission.Confirmation {
  private static final String PROGRAM = "jopenshowvar";

  private final Writer data;
  private final PrintWriter out;
  private final PrintWriter err;
  private final Map<String, String> environment;
  private final Reader in;
  private final @Nullable Prompt questions;
  private final org.jline.terminal.@Nullable Terminal terminal;

  /** Asks a person; only used if there is one. */
  @FunctionalInterface
  public interface Prompt {
    /** Returns the typed line; null at the end of the input. */
    @Nullable String ask(String question);
  }

  /**
   * Creates a console.
   *
   * @param environment the environment variables
   */
  public Console(Writer out, Writer err, Map<String, String> environment) {
    this(out, err, environment, new InputStreamReader(System.in, charset("stdin.encoding")), null);
  }

  /**
   * Creates a console that has another stdin.
   *
   * @param questions asks the user; null to ask on the terminal
   */
  public Console(
      Writer out,
      Writer err,
      Map<String, String> environment,
      Reader in,
      @Nullable Prompt questions) {
    this(out, err, environment, in, questions, null);
  }

  private Console(
      Writer out,
      Writer err,
      Map<String, String> environment,
      Reader in,
      @Nullable Prompt questions,
      org.jline.terminal.@Nullable Terminal terminal) {
    this.environment = Map.copyOf(environment);
    this.data = out;
    this.out = new PrintWriter(out, true);
    this.err = new PrintWriter(err, true);
    this.in = in;
    this.questions = questions;
    this.terminal = terminal;
  }

  /**
   * Returns this console on an open terminal, such as that of a line editor.
   *
   * @param prompt asks the user there
   */
  public Console on(org.jline.terminal.Terminal open, Prompt prompt) {
    return new Console(data, err, environment, in, prompt, open);
  }

  /** Returns the open terminal; null if none is open. */
  org.jline.terminal.@Nullable Terminal terminal() {
    return terminal;
  }

  /**
   * Returns the charset of one of the streams of the process.
   *
   * @param encoding the property that names it, since JDK 19 and for stdin since JDK 25; before
   *     that its name began with {@code sun.}, and it was set only for a terminal
   */
  public static Charset charset(String encoding) {
    String name = System.getProperty("sun." + encoding, System.getProperty("native.encoding"));
    Charset charset = Charset.forName(System.getProperty(encoding, name));
    // the user did not choose the locale C; the controller has characters of ISO 8859-1
    return charset.equals(StandardCharsets.US_ASCII) ? StandardCharsets.UTF_8 : charset;
  }

  /** Returns stdin. */
  public Reader in() {
    return in;
  }

  /** Returns stdout for texts of picocli. It hides errors, so data goes through {@link #print}. */
  public PrintWriter out() {
    return out;
  }

  public PrintWriter err() {
    return err;
  }

  /** Returns an environment variable, null if it is not set or empty. */
  public @Nullable String environment(String name) {
    String value = environment.get(name);
    return value == null || value.isEmpty() ? null : value;
  }

  /** Returns whether a person can be asked. */
  @Override
  public boolean isInteractive() {
    return questions != null || Terminal.isTerminal();
  }

  /** Asks a question; only y and yes are a yes, and only if they are typed after it. */
  @Override
  public boolean confirm(String question) {
    String answer = answer(PrintableText.shortened(question), " [y/N] ");
    return answer != null && answer.strip().matches("(?i)y(es)?");
  }

  private @Nullable String answer(String question, String choices) {
    if (questions != null) {
      return questions.ask(question + choices);
    }
    err.print(question);
    err.flush();
    String answer = null;
    try {
      TypedKeys.drop();
      err.print(choices);
      err.flush();
      answer = Terminal.readLine();
    } catch (IOException e) {
      err.print(": " + e.getMessage());
    }
    if (answer == null) {
      err.println(); // no Enter has moved the cursor
    }
    return answer;
  }

  /**
   * Prints a line of data, with the characters escaped that are not safe on a terminal.
   *
   * @throws OutputException if it cannot be written, for example to a closed pipe
   */
  public void print(String line) {
    write(PrintableText.of(line) + System.lineSeparator());
  }

  /**
   * Prints a change of the controller, or of a file.
   *
   * @param change the change as a line of text
   * @param line the line to print, which can be JSON
   * @throws OutputException as {@link #print}; it names the change
   */
  public void printChange(String change, String line) {
    try {
      print(line);
    } catch (OutputException e) {
      throw e.after(change);
    }
  }

  /**
   * Prints data that has its own line ends, exactly as it is.
   *
   * @throws OutputException as {@link #print}
   */
  public void write(String text) {
    try {
      data.write(text);
      data.flush();
    } catch (IOException e) {
      throw new OutputException(e);
    }
  }

  /** Prints a message, which becomes one line of limited length, after the program's name. */
  public void error(String message) {
    err.println(PROGRAM + ": " + PrintableText.shortened(message));
  }

  /** Prints the message of an exception, and its origin if requested. */
  public void failure(Throwable e, boolean verbose) {
    failure("", e, verbose);
  }

  /**
   * Reports a failure of one of several robots.
   *
   * @param label the text before the message, see {@link Robot#label}
   */
  public void failure(String label, Throwable e, boolean verbose) {
    error(label + e.getMessage());
    if (e instanceof FileException file) {
      file.details().forEach(this::hint);
    }
    if (verbose) {
      trace(e);
    }
  }

  /** Prints a stack trace. */
  public void trace(Throwable e) {
    err.print(StackTrace.of(e));
    err.flush();
  }

  /** Prints a line that helps with the message before it. */
  public void hint(String line) {
    err.println(PrintableText.shortened(line));
  }
}
