package no.hials.crosscom.internal;

import java.util.concurrent.CancellationException;

/** Tells an operation of many exchanges whether it is cancelled. */
public interface Cancellation {
  /** Never cancelled. */
  Cancellation NEVER =
      new Cancellation() {
        @Override
        public void check() {}

        @Override
        public void commit() {}
      };

  /**
   * Ends the operation if it is cancelled.
   *
   * @throws CancellationException if so
   */
  void check();

  /**
   * Ensures that the operation is not cancelled, neither now nor later. Calling it again does
   * nothing.
   *
   * @throws CancellationException if the operation is cancelled
   */
  void commit();
}
