package no.hials.crosscom.control.input;

import java.io.IOException;
import org.jline.nativ.Kernel32;
import org.jline.terminal.Attributes;
import org.jline.terminal.Terminal;
import org.jline.terminal.TerminalBuilder;

/**
 * The keys that were typed on the terminal of this process before a program needs them. The class
 * needs JLine ({@code org.jline:jline}), as {@link KeyboardInput} does.
 */
public final class TypedKeys {
  private TypedKeys() {}

  /**
   * Drops the keys that were typed before now, so that they do not answer a question.
   *
   * @throws IOException without a terminal, or if its settings cannot be changed
   */
  public static void drop() throws IOException {
    if (isWindows()) {
      flush();
      return;
    }
    try (Terminal terminal = openTerminal()) {
      drop(terminal);
    } catch (IllegalStateException e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  /** Opens the terminal of this process. */
  static Terminal openTerminal() throws IOException {
    try {
      return TerminalBuilder.builder()
          .system(true)
          // the native library is faster; stty works where it cannot be loaded
          .providers("jni,exec")
          .dumb(false)
          .nativeSignals(false)
          // otherwise JLine queries the terminal, and a late answer looks like keys
          .graphemeCluster(false)
          .build();
    } catch (IllegalStateException e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  /**
   * Drops the keys on a terminal.
   *
   * @throws IllegalStateException if the terminal is closed
   */
  static void drop(Terminal terminal) throws IOException {
    if (isWindows()) {
      flush();
      return;
    }
    // in line mode the system keeps an unfinished line, which a later Enter would complete
    Attributes before = terminal.enterRawMode();
    try {
      for (int typed = System.in.available(); typed > 0; typed = System.in.available()) {
        System.in.readNBytes(typed);
      }
    } finally {
      terminal.setAttributes(before);
    }
  }

  private static boolean isWindows() {
    return System.getProperty("os.name", "").startsWith("Windows");
  }

  private static void flush() {
    Kernel32.FlushConsoleInputBuffer(Kernel32.GetStdHandle(Kernel32.STD_INPUT_HANDLE));
  }
}
