package no.hials.crosscom.c3;

import java.util.concurrent.atomic.AtomicBoolean;
import no.hials.crosscom.CrossComException;

/** A pressed key of the pendant; closing it releases the key. Thread-safe. */
public final class PressedKey implements AutoCloseable {
  private final Pendant pendant;
  private final KeyAction key;
  private final AtomicBoolean released = new AtomicBoolean();

  PressedKey(Pendant pendant, KeyAction key) {
    this.pendant = pendant;
    this.key = key;
  }

  /** Returns the key. */
  public KeyAction key() {
    return key;
  }

  /**
   * Releases the key, also in an interrupted thread. If the outcome is unknown, the release is sent
   * once more: releasing a key twice moves nothing. Closing again does nothing after a success, and
   * tries again after a failure.
   *
   * @throws CrossComException if the server refuses, or the exchange fails: the key may still be
   *     pressed
   */
  @Override
  public void close() throws CrossComException {
    if (released.getAndSet(true)) {
      return;
    }
    // an exchange does not begin in an interrupted thread, and the machine would keep moving
    boolean interrupted = Thread.interrupted();
    boolean done = false;
    try {
      release();
      done = true;
    } finally {
      released.set(done);
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  /** Releases the key, and adds a failure to the failure of the press. */
  void releaseAfter(CrossComException failure) {
    try {
      close();
    } catch (CrossComException e) {
      failure.addSuppressed(e);
    }
  }

  private void release() throws CrossComException {
    try {
      pendant.release(key);
    } catch (CrossComException e) {
      if (!e.isOutcomeUnknown()) {
        throw e;
      }
      try {
        pendant.release(key);
      } catch (CrossComException again) {
        again.addSuppressed(e);
        throw again;
      }
    }
  }
}
