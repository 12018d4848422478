package no.hials.crosscom.cli.shell;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cli.base.Console;
import org.jline.reader.EndOfFileException;
import org.jline.reader.LineReader;
import org.jline.reader.LineReaderBuilder;
import org.jline.reader.UserInterruptException;
import org.jline.terminal.Terminal.Signal;
import org.jline.terminal.TerminalBuilder;
import org.jline.utils.AttributedString;
import org.jline.utils.AttributedStringBuilder;
import org.jline.utils.AttributedStyle;
import org.jline.utils.Signals;
import org.jspecify.annotations.Nullable;

/**
 * The terminal of a shell: edits and completes lines, and keeps a history. Ctrl-C discards a line
 * that is being typed; while a line runs, it interrupts the thread that created this object.
 */
final class ShellTerminal implements Closeable {
  private static final int MAX_HISTORY = 2000;

  /** The time in which JLine passes on a key that was typed. */
  private static final long READ_AHEAD_MILLIS = 50;

  private final org.jline.terminal.Terminal terminal;
  private final LineReader reader;
  private final LineReader questions;
  private final boolean coloured;

  /** The previous handler of Ctrl-C. */
  private final @Nullable Object interruptBefore;

  ShellTerminal(Console console, ShellCompleter completer) throws IOException {
    coloured = console.environment("NO_COLOR") == null;
    // otherwise JLine also turns a Ctrl-C in a typed line into a signal; if the signal comes before
    // the key, the key discards the next line
    System.setProperty(TerminalBuilder.PROP_SOFTWARE_SIGNALS, "false");
    terminal =
        TerminalBuilder.builder()
            .system(true)
            // the native library is faster; stty works where it cannot be loaded
            .providers("jni,exec")
            .dumb(true)
            // with JLine's handler, Ctrl-C would end this process before the terminal is restored
            .nativeSignals(false)
            .build();
    Thread runner = Thread.currentThread();
    interruptBefore = Signals.register("INT", runner::interrupt);
    Signals.register("WINCH", () -> terminal.raise(Signal.WINCH));
    Signals.register("CONT", () -> terminal.raise(Signal.CONT));
    reader =
        LineReaderBuilder.builder()
            .terminal(terminal)
            .appName("jopenshowvar")
            .parser(new ShellParser())
            .completer(completer)
            .variable(LineReader.HISTORY_SIZE, MAX_HISTORY)
            .variable(LineReader.ERRORS, 0)
            .option(LineReader.Option.CASE_INSENSITIVE, true)
            .option(LineReader.Option.DISABLE_EVENT_EXPANSION, true)
            .option(LineReader.Option.HISTORY_TIMESTAMPED, false)
            .option(LineReader.Option.INSERT_TAB, false)
            .build();
    questions =
        LineReaderBuilder.builder()
            .terminal(terminal)
            .variable(LineReader.DISABLE_HISTORY, true)
            .option(LineReader.Option.DISABLE_EVENT_EXPANSION, true)
            .build();
    questions.getWidgets().put(LineReader.CALLBACK_INIT, this::dropTyped);
    keepHistory(console);
    (coloured ? ShellCompleter.COLOURED : ShellCompleter.PLAIN).forEach(reader::setVariable);
  }

  /**
   * Returns the file of the history.
   *
   * @param state the value of XDG_STATE_HOME
   */
  static Path history(@Nullable String state) {
    // a relative path must be ignored (XDG Base Directory Specification)
    Path base =
        state != null && Path.of(state).isAbsolute()
            ? Path.of(state)
            : Path.of(System.getProperty("user.home"), ".local", "state");
    return base.resolve("jopenshowvar").resolve("history");
  }

  /** Keeps a history, if its file can be written and read; otherwise JLine would fail. */
  private void keepHistory(Console console) {
    Path file = history(console.environment("XDG_STATE_HOME"));
    try {
      Files.createDirectories(file.getParent());
      boolean old = Files.exists(file);
      if (old) {
        Files.readString(file);
      }
      // JLine creates the file, readable by the user only
      if (!Files.isWritable(old ? file : file.getParent())) {
        throw new AccessDeniedException(file.toString());
      }
      reader.setVariable(LineReader.HISTORY_FILE, file);
    } catch (IOException e) {
      console.error(
          "the history is not saved: " + FileException.cannot("use", file, e).getMessage());
    }
  }

  /**
   * Returns a typed line, or several that were pasted at once; empty after Ctrl-C; null at the end.
   */
  @Nullable String readLine(ShellPrompt prompt) {
    // the operation stopped by Ctrl-C has ended
    Thread.interrupted();
    String text = text(prompt);
    return read(reader, text, "");
  }

  /** Returns a console whose questions and screens are on this terminal. */
  Console console(Console other) {
    return other.on(terminal, this::ask);
  }

  /** Returns an answer that is typed after the question, null for none. */
  private @Nullable String ask(String question) {
    return read(questions, question, null);
  }

  /** Drops the keys that were typed before a question. Called when JLine is about to show it. */
  private boolean dropTyped() {
    try {
      while (terminal.reader().read(READ_AHEAD_MILLIS) >= 0) {
        // the terminal passes on single keys by now, also those of an unfinished line
      }
    } catch (IOException e) {
      Thread.currentThread().interrupt(); // there is no answer, as after Ctrl-C
    }
    return true;
  }

  private static @Nullable String read(
      LineReader from, String prompt, @Nullable String ifInterrupted) {
    try {
      return from.readLine(prompt);
    } catch (UserInterruptException e) {
      return ifInterrupted;
    } catch (EndOfFileException e) {
      return null;
    }
  }

  private String text(ShellPrompt prompt) {
    String mode = prompt.mode();
    if (mode.isEmpty()) {
      return prompt.name() + "> ";
    }
    AttributedStyle style =
        coloured ? AttributedStyle.BOLD.foreground(AttributedStyle.RED) : AttributedStyle.DEFAULT;
    AttributedString text =
        new AttributedStringBuilder()
            .append(prompt.name() + " ")
            .styled(style, mode)
            .append("> ")
            .toAttributedString();
    return text.toAnsi(terminal);
  }

  /** Restores the terminal. */
  @Override
  public void close() throws IOException {
    terminal.close();
    if (interruptBefore != null) { // as where signals cannot be handled
      Signals.unregister("INT", interruptBefore);
    }
  }
}
