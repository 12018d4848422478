package no.hials.crosscom.cli.base;

import java.util.Locale;
import no.hials.crosscom.c3.TransferProgress;

/** Shows how far a transfer has come, on a line that changes in place. */
public final class Progress implements TransferProgress, AutoCloseable {
  private final String name;
  private final boolean shown;
  private final LiveLine line;
  private final StopSignal stop;

  /**
   * Creates a line that is not shown yet.
   *
   * @param name the file to transfer
   * @param shown whether to show it
   * @param stop ends the transfer without a trace
   */
  public Progress(Console console, String name, boolean shown, StopSignal stop) {
    this.name = name;
    this.shown = shown;
    this.line = new LiveLine(console.err(), shown);
    this.stop = stop;
  }

  @Override
  public void transferred(long bytes, long total) {
    stop.check();
    // always show the end, since the check of the content takes as long as the transfer
    if (line.isDue() || (shown && bytes == total)) {
      line.show(text(name, bytes, total));
    }
  }

  @Override
  public void close() {
    line.close();
  }

  public static String text(String name, long bytes, long total) {
    if (bytes == total) {
      return name + ": all of " + kilobytes(total) + ", checking";
    }
    return String.format(
        Locale.ROOT, "%s: %d %% of %s", name, bytes * 100 / total, kilobytes(total));
  }

  private static String kilobytes(long bytes) {
    return (bytes + 1023) / 1024 + " KB";
  }
}
