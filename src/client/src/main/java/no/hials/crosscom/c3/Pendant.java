package no.hials.crosscom.c3;

import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComUnsupportedException;

/**
 * Presses and releases keys of the teach pendant (docs/reference/c3-messages.md#pendant-keys-12).
 *
 * <p><b>A pressed key moves a machine until it is released.</b> {@link #hold} releases it when a
 * block ends, however it ends:
 *
 * <pre>{@code
 * try (PressedKey key = client.pendant().hold(KeyAction.jog(3, 2, true))) {
 *   // the axis moves
 * }
 * }</pre>
 *
 * <p>If this program, its machine or the network fails meanwhile, nothing releases the key.
 *
 * <p>Thread-safe. All methods block for at most the request time-out. They throw {@link
 * CrossComUnsupportedException} on KUKAVARPROXY, before anything is pressed; {@link
 * CrossComRefusedException} with the server's code if it refuses; another {@link CrossComException}
 * if the exchange fails.
 *
 * <p>Programs get this object from {@link no.hials.crosscom.CrossComClient#pendant}.
 */
public interface Pendant {
  /**
   * Presses a key, and leaves it pressed.
   *
   * @param key the key
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  void press(KeyAction key) throws CrossComException;

  /**
   * Releases a key.
   *
   * @param key the key
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  void release(KeyAction key) throws CrossComException;

  /**
   * Presses a key until the result is closed. If it is not known whether the key is pressed, it is
   * released at once.
   *
   * @param key the key
   * @return the pressed key, to be closed
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails; if
   *     {@link CrossComException#isOutcomeUnknown}, the key was released, or a suppressed exception
   *     says why not
   */
  default PressedKey hold(KeyAction key) throws CrossComException {
    PressedKey pressed = new PressedKey(this, key);
    try {
      press(key);
    } catch (CrossComException e) {
      if (e.isOutcomeUnknown()) {
        pressed.releaseAfter(e);
      }
      throw e;
    }
    return pressed;
  }
}
