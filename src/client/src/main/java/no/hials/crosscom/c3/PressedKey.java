package no.hials.crosscom.c3;

import java.util.concurrent.atomic.AtomicBoolean;
import no.hials.crosscom.CrossComException;

/** A pressed key of the pendant, which is released when this is closed. For several threads. */
public final class PressedKey implements AutoCloseable {
  private final Pendant pendant;
  private final KeyAction key;
  private final AtomicBoolean released = new AtomicBoolean();

  PressedKey(Pendant pendant, KeyAction key) {
    this.pendant = pendant;
    this.key = key;
  }

  /**
   * Gives the key.
   *
   * @return which
   */
  public KeyAction key() {
    return key;
  }

  /**
   * Releases the key, also in a thread that was interrupted. If the exchange fails so that nobody
   * knows, it is done once more: releasing a key twice moves nothing. After a success, closing
   * again does nothing; after a failure, it tries again.
   *
   * @throws CrossComException if the server refused, or the exchange failed: the key may still be
   *     pressed
   */
  @Override
  public void close() throws CrossComException {
    if (released.getAndSet(true)) {
      return;
    }
    // an exchange refuses to begin in an interrupted thread, and the machine would go on moving
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
