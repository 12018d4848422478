package no.hials.crosscom.control.input;

import java.util.List;

/**
 * The state of an input device at one time.
 *
 * @param axes the deflections, -1 to 1
 * @param buttons whether each button is pressed
 * @param deadMan whether the person holds the dead-man, which allows motion
 * @param nanoTime the time of the person's last input, as {@link System#nanoTime}
 */
public record Input(List<Double> axes, List<Boolean> buttons, boolean deadMan, long nanoTime) {
  /** No axes, no buttons and no motion. */
  public static final Input NONE = new Input(List.of(), List.of(), false, 0);

  /** Checks the range of the axes. */
  public Input {
    axes = List.copyOf(axes);
    buttons = List.copyOf(buttons);
    for (double axis : axes) {
      // The negation also refuses NaN.
      if (!(axis >= -1 && axis <= 1)) {
        throw new IllegalArgumentException("an axis must be -1 to 1, is " + axis);
      }
    }
  }

  /**
   * Returns the deflection of an axis.
   *
   * @param index from 0
   * @return -1 to 1; 0 for an axis that the device does not have
   */
  public double axis(int index) {
    return index < axes.size() ? axes.get(index) : 0;
  }

  /**
   * Returns whether a button is pressed.
   *
   * @param index from 0
   * @return false for a button that the device does not have
   */
  public boolean button(int index) {
    return index < buttons.size() && buttons.get(index);
  }

  /**
   * Returns this input with a dead zone and a scale: the axes go from 0 at the edge of the zone to
   * the scale at full deflection, without a step.
   *
   * @param deadZone the deflection up to which an axis is 0; 0 to less than 1
   * @param scale the value at full deflection; -1 to 1
   */
  public Input shaped(double deadZone, double scale) {
    checkShape(deadZone, scale);
    List<Double> shaped =
        axes.stream()
            .map(axis -> scale * Math.signum(axis) * beyond(Math.abs(axis), deadZone))
            .toList();
    return new Input(shaped, buttons, deadMan, nanoTime);
  }

  private static double beyond(double deflection, double deadZone) {
    return Math.max(0, (deflection - deadZone) / (1 - deadZone));
  }

  static void checkShape(double deadZone, double scale) {
    if (!(deadZone >= 0 && deadZone < 1)) {
      throw new IllegalArgumentException("a dead zone must be 0 to less than 1, is " + deadZone);
    }
    if (!(scale >= -1 && scale <= 1)) {
      throw new IllegalArgumentException("a scale must be -1 to 1, is " + scale);
    }
  }
}
