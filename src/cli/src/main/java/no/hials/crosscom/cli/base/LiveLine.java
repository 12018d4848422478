package no.hials.crosscom.cli.base;

import java.io.PrintWriter;
import no.hials.crosscom.protocol.value.PrintableText;

/** A line of a terminal that changes in place. */
public final class LiveLine implements AutoCloseable {
  private static final long PERIOD_NANOS = 250_000_000;

  /** Clears the line from the cursor on. */
  private static final String CLEAR_REST = "\u001b[K";

  /** Makes the terminal cut off long lines; a wrapped line could not be cleared. */
  private static final String NO_WRAP = "\u001b[?7l";

  private static final String WRAP = "\u001b[?7h";

  private final PrintWriter terminal;
  private final boolean shown;
  private boolean isThere;
  private long next = System.nanoTime();

  /**
   * Creates a line that is not shown yet.
   *
   * @param terminal the terminal
   * @param shown whether to show the line at all
   */
  public LiveLine(PrintWriter terminal, boolean shown) {
    this.terminal = terminal;
    this.shown = shown;
  }

  /** Returns whether it is time for another text, four times a second. */
  public boolean isDue() {
    if (!shown || System.nanoTime() - next < 0) {
      return false;
    }
    next = System.nanoTime() + PERIOD_NANOS;
    return true;
  }

  /** Shows another text, with the characters escaped that are not safe on a terminal. */
  public void show(String text) {
    // clear only what follows the text, or the line would flicker; then return to its beginning,
    // where the terminal shows Ctrl-C
    write(NO_WRAP + PrintableText.of(text) + CLEAR_REST + WRAP + "\r");
    isThere = true;
  }

  /** Clears the line until the next {@link #show}. */
  public void clear() {
    if (isThere) {
      write("\r" + CLEAR_REST);
      isThere = false;
    }
  }

  private void write(String text) {
    terminal.print(text);
    terminal.flush();
  }

  @Override
  public void close() {
    clear();
  }
}
