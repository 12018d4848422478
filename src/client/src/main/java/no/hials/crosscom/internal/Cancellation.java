package no.hials.crosscom.internal;

import java.util.concurrent.CancellationException;

/** Cancels an operation of many exchanges. */
public interface Cancellation {
  /** Never cancelled. */
  Cancellation NEVER =
      new Cancellation() {
        @Override
        public void check() {}

        @Override
        public void commit() {}
      };

  /** Throws a {@link CancellationException} if the operation is cancelled. */
  void check();

  /**
   * Throws a {@link CancellationException} if the operation is cancelled, and ensures that it is
   * not cancelled later. Calling it again does nothing.
   */
  void commit();
}
