package no.hials.crosscom.internal;

import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/** Cancels an operation of many exchanges. */
public interface Cancellation {
  /** Never cancelled. */
  Cancellation NEVER = new Cancellation() {};

  /** Throws a {@link CancellationException} if the operation is cancelled. */
  default void check() {}

  /**
   * Throws a {@link CancellationException} if the operation is cancelled, and ensures that it is
   * not cancelled later. Calling it again does nothing.
   */
  default void commit() {}

  /** Lets {@link #commit} cancel the operation if a condition is false by then. */
  default void commitIf(BooleanSupplier condition) {}
}
