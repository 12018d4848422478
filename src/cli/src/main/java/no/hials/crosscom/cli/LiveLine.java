package no.hials.crosscom.cli;

/** A line of stderr that changes in place, where a person looks on. */
final class LiveLine implements AutoCloseable {
  private static final long PERIOD_NANOS = 250_000_000;

  private final Console console;
  private final boolean shown;
  private boolean isThere;
  private long next = System.nanoTime();

  /**
   * Makes a line that is not there yet.
   *
   * @param shown whether it is to be there at all
   */
  LiveLine(Console console, boolean shown) {
    this.console = console;
    this.shown = shown;
  }

  /** Says whether it is time for another text, four times a second. */
  boolean isDue() {
    if (!shown || System.nanoTime() - next < 0) {
      return false;
    }
    next = System.nanoTime() + PERIOD_NANOS;
    return true;
  }

  /** Shows another text. */
  void show(String text) {
    // back to its beginning, where the terminal shows Ctrl-C
    write(StatusLine.NO_WRAP + text + StatusLine.CLEAR_REST + StatusLine.WRAP + "\r");
    isThere = true;
  }

  /** Takes the line away, until the next {@link #show}. */
  void clear() {
    if (isThere) {
      write("\r" + StatusLine.CLEAR_REST);
      isThere = false;
    }
  }

  private void write(String text) {
    console.err().print(text);
    console.err().flush();
  }

  @Override
  public void close() {
    clear();
  }
}
