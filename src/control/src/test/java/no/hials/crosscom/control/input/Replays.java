package no.hials.crosscom.control.input;

import java.io.IOException;
import java.io.StringReader;
import java.util.function.LongSupplier;

/** Lets tests of other packages replay in the time of a simulation. */
public final class Replays {
  private Replays() {}

  /**
   * Makes a replay.
   *
   * @param csv its text
   * @param clock gives the time, ns
   * @return the device
   * @throws IOException if a line is not as it must be
   */
  public static CsvReplay of(String csv, LongSupplier clock) throws IOException {
    return CsvReplay.load(new StringReader(csv), "test", clock);
  }
}
