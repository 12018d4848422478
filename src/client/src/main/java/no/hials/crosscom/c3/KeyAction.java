package no.hials.crosscom.c3;

import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.PendantKey;

/**
 * A key of the pendant and its target, to press or release
 * (docs/reference/c3-messages.md#pendant-keys-12).
 *
 * @param key the key
 * @param number the interpreter's number for start and stop, the axis for jog and mouse
 * @param keyCode which key of several; 0 for start and stop. The reference has one example of a
 *     jog, with 2 (docs/reference/c3-messages.md#examples), and does not explain the number
 * @param direction false for forward, as in the example of a start; true for plus, as in that of a
 *     jog (docs/reference/c3-messages.md#examples). The meaning of the opposite values is assumed
 */
public record KeyAction(Code<PendantKey> key, int number, int keyCode, boolean direction) {

  /**
   * Returns the key that starts the program forward.
   *
   * @param interpreter the interpreter of the program
   * @return the key
   */
  public static KeyAction start(Interpreter interpreter) {
    return new KeyAction(Code.of(PendantKey.START), interpreter.code(), 0, false);
  }

  /**
   * Returns the key that starts the program backward.
   *
   * @param interpreter the interpreter of the program
   * @return the key
   */
  public static KeyAction startBackward(Interpreter interpreter) {
    return new KeyAction(Code.of(PendantKey.START), interpreter.code(), 0, true);
  }

  /**
   * Returns the key that stops the program.
   *
   * @param interpreter the interpreter of the program
   * @return the key
   */
  public static KeyAction stop(Interpreter interpreter) {
    return new KeyAction(Code.of(PendantKey.STOP), interpreter.code(), 0, false);
  }

  /**
   * Returns the key that moves one axis.
   *
   * @param axis its number, from 1
   * @param keyCode which key; see {@link #keyCode}
   * @param plus whether in plus direction
   * @return the key
   */
  public static KeyAction jog(int axis, int keyCode, boolean plus) {
    return new KeyAction(Code.of(PendantKey.JOG), axis, keyCode, plus);
  }

  /**
   * Returns a deflection of the 6D mouse.
   *
   * @param axis its number, from 1 (assumed)
   * @param keyCode which key; see {@link #keyCode}
   * @param plus whether in plus direction
   * @return the key
   */
  public static KeyAction mouse(int axis, int keyCode, boolean plus) {
    return new KeyAction(Code.of(PendantKey.MOUSE), axis, keyCode, plus);
  }

  /** Returns the key and its target in words. */
  @Override
  public String toString() {
    return "key "
        + key
        + " (number "
        + number
        + ", key code "
        + keyCode
        + ", direction "
        + (direction ? 1 : 0)
        + ")";
  }
}
