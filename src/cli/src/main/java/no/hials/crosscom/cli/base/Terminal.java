package no.hials.crosscom.cli.base;

import java.io.ByteArrayOutputStream;
import java.io.Console;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/** Checks whether a person uses the terminal of this process. */
public final class Terminal {
  private static final Path OWN_STATE = Path.of("/proc/self/stat");
  private static final Path OWN_STDERR = Path.of("/proc/self/fd/2");

  private Terminal() {}

  /**
   * Returns whether stdin and stdout are a terminal that can clear a line. Returns false if {@code
   * TERM} is not set, as on Windows, because it is then unknown whether the terminal can.
   */
  public static boolean isInteractive() {
    String kind = System.getenv("TERM");
    return kind != null && !kind.isBlank() && !kind.equals("dumb") && isTerminal();
  }

  /** Returns whether stdin and stdout are a terminal, of whatever kind. */
  @SuppressWarnings("SystemConsoleNull") // of the newer ones the method below tells
  static boolean isTerminal() {
    Console console = System.console();
    if (console == null) {
      return false;
    }
    try {
      // since JDK 22 a console may have no terminal; the method isTerminal exists since then, too
      return (Boolean) Console.class.getMethod("isTerminal").invoke(console);
    } catch (NoSuchMethodException e) {
      return true;
    } catch (ReflectiveOperationException e) {
      return false;
    }
  }

  /** Returns whether only a person reads stderr. */
  public static boolean showsProgress() {
    return isInteractive() && isForeground() && isErrTerminal();
  }

  /** Returns whether stderr is a terminal; if unknown, whether stdout is. */
  private static boolean isErrTerminal() {
    try {
      String target = Files.readSymbolicLink(OWN_STDERR).toString();
      return target.startsWith("/dev/pts/") || target.startsWith("/dev/tty");
    } catch (IOException | UnsupportedOperationException e) {
      return true;
    }
  }

  /**
   * Reads a line from the user; null at the end of the input. Reads no key after the line, as a
   * {@link Console} does, so that dropping the typed keys misses none.
   */
  static @Nullable String readLine() throws IOException {
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    int next = System.in.read();
    if (next < 0) {
      return null;
    }
    while (next >= 0 && next != '\n') {
      line.write(next);
      next = System.in.read();
    }
    return line.toString(no.hials.crosscom.cli.base.Console.charset("stdin.encoding"));
  }

  /** Returns whether the terminal is this process's, and not a shell's; true if unknown. */
  public static boolean isForeground() {
    try {
      // man 5 proc: the name in brackets, state, parent, process group, session, terminal, and the
      // process group in the foreground of the terminal
      String state = Files.readString(OWN_STATE, StandardCharsets.ISO_8859_1);
      String[] fields = state.substring(state.lastIndexOf(')') + 1).strip().split(" ", -1);
      return fields[2].equals(fields[5]);
    } catch (IOException e) {
      return true;
    }
  }
}
