package no.hials.crosscom.cell;

/**
 * A time on both clocks of the machine. The monotonic one stands still while a virtual machine is
 * suspended, and the other one can be set.
 *
 * @param nanos the time by {@link System#nanoTime}
 * @param millis the time by {@link System#currentTimeMillis}
 */
public record Moment(long nanos, long millis) {
  /** Returns the time now. */
  public static Moment now() {
    return new Moment(System.nanoTime(), System.currentTimeMillis());
  }

  /** Returns the time since an earlier moment, by the clock that has moved further. */
  public long nanosSince(Moment before) {
    return Math.max(nanos - before.nanos, (millis - before.millis) * 1_000_000);
  }
}
