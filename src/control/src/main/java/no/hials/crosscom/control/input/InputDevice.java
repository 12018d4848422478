package no.hials.crosscom.control.input;

import java.io.Closeable;
import java.io.IOException;

/** Gives what a person does with a device. */
@FunctionalInterface
public interface InputDevice extends Closeable {
  /**
   * Gives the latest state. It must not block, and may be called by any thread, one at a time.
   *
   * @return what the device says now, with the time from which it is
   * @throws IOException if the device has failed for good, which stops the robot
   */
  Input read() throws IOException;

  /** Ends the device; does nothing unless it says otherwise. */
  @Override
  default void close() throws IOException {}

  /**
   * Puts a dead zone and a scale behind the axes of this device; see {@link Input#shaped}.
   *
   * @param deadZone how far from the centre an axis still is at 0; 0 to less than 1
   * @param scale what full deflection gives; -1 to 1
   * @return a device that closes this one when it is closed
   */
  default InputDevice shaped(double deadZone, double scale) {
    Input.checkShape(deadZone, scale);
    InputDevice raw = this;
    return new InputDevice() {
      @Override
      public Input read() throws IOException {
        return raw.read().shaped(deadZone, scale);
      }

      @Override
      public void close() throws IOException {
        raw.close();
      }
    };
  }
}
