package no.hials.crosscom.control.input;

import java.io.Closeable;
import java.io.IOException;

/** A device with which a person moves a robot. */
@FunctionalInterface
public interface InputDevice extends Closeable {
  /**
   * Returns the latest state. It must not block. Any thread may call it, one at a time.
   *
   * @return the state with its time
   * @throws IOException if the device has failed permanently, which stops the robot
   */
  Input read() throws IOException;

  /** Closes the device. Does nothing by default. */
  @Override
  default void close() throws IOException {}

  /**
   * Returns a device with a dead zone and a scale for the axes of this device; see {@link
   * Input#shaped}.
   *
   * @param deadZone the deflection up to which an axis is 0; 0 to less than 1
   * @param scale the value at full deflection; -1 to 1
   * @return a device that closes this device when it is closed
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
