package no.hials.crosscom.cli;

import java.io.Console;

/** Knows whether a person looks on. */
final class Terminal {
  private Terminal() {}

  /** Says whether stdin and stdout are a terminal. */
  @SuppressWarnings("SystemConsoleNull") // of the newer ones the method below tells
  static boolean isInteractive() {
    Console console = System.console();
    if (console == null) {
      return false;
    }
    try {
      // since JDK 22 there is a console without a terminal, too, and this method to tell them apart
      return (Boolean) Console.class.getMethod("isTerminal").invoke(console);
    } catch (NoSuchMethodException e) {
      return true;
    } catch (ReflectiveOperationException e) {
      return false;
    }
  }
}
