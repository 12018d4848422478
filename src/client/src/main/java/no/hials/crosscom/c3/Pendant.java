package no.hials.crosscom.c3;

import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComUnsupportedException;
import no.hials.crosscom.internal.MessageChannel;
import no.hials.crosscom.protocol.program.PendantKeyRequest;
import no.hials.crosscom.protocol.program.PendantKeyResponse;

/**
 * Presses and releases keys of the teach pendant (c3-bridge.md, type 12).
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
 * <p>If this program, its machine or the network dies meanwhile, nothing releases the key.
 *
 * <p>For several threads. All methods block for the request time-out at most, and throw: {@link
 * CrossComUnsupportedException} on KUKAVARPROXY, before anything is pressed; {@link
 * CrossComRefusedException} with the server's code if it refused; another {@link CrossComException}
 * if the exchange failed.
 */
public final class Pendant {
  private final MessageChannel link;

  /**
   * Makes the object of a client. For the client; programs get it from {@link
   * no.hials.crosscom.CrossComClient#pendant}.
   *
   * @param link sends the messages
   */
  public Pendant(MessageChannel link) {
    this.link = link;
  }

  /**
   * Presses a key, and leaves it pressed.
   *
   * @param key which
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void press(KeyAction key) throws CrossComException {
    send(key, false);
  }

  /**
   * Releases a key.
   *
   * @param key which
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void release(KeyAction key) throws CrossComException {
    send(key, true);
  }

  /**
   * Presses a key until the result is closed. If it is not known whether it is pressed, it is
   * released at once.
   *
   * @param key which
   * @return the key, to be closed
   * @throws CrossComException if the server cannot, refused, or the exchange failed; if {@link
   *     CrossComException#isOutcomeUnknown}, the key was released, or it has a suppressed exception
   *     that says why not
   */
  public PressedKey hold(KeyAction key) throws CrossComException {
    PressedKey pressed = new PressedKey(this, key);
    try {
      press(key);
    } catch (CrossComException e) {
      if (e.isOutcomeUnknown()) {
        releaseAfter(e, pressed);
      }
      throw e;
    }
    return pressed;
  }

  private static void releaseAfter(CrossComException failure, PressedKey pressed) {
    try {
      pressed.close();
    } catch (CrossComException e) {
      failure.addSuppressed(e);
    }
  }

  private void send(KeyAction key, boolean released) throws CrossComException {
    link.ask(
        new PendantKeyRequest(0, key.key(), key.number(), key.keyCode(), key.direction(), released),
        PendantKeyResponse.class,
        (released ? "release of " : "press of ") + key);
  }
}
