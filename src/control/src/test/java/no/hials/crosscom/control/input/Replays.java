package no.hials.crosscom.control.input;

import java.io.IOException;
import java.io.StringReader;
import java.util.function.LongSupplier;

/** Lets tests of other packages replay in simulated time. */
public final class Replays {
  private Replays() {}

  /**
   * Creates a replay.
   *
   * @param csv its text
   * @param clock returns the time, ns
   * @return the device
   * @throws IOException if a line is invalid
   */
  public static CsvReplay of(String csv, LongSupplier clock) throws IOException {
    return CsvReplay.load(new StringReader(csv), "test", clock);
  }
}
