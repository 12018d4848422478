package no.hials.crosscom.control.input;

import java.util.List;

/**
 * What an input device said at one time.
 *
 * @param axes the deflections, -1 to 1
 * @param buttons which buttons are pressed
 * @param deadMan whether the person holds what allows motion
 * @param nanoTime when the device last heard of the person, as {@link System#nanoTime}
 */
public record Input(List<Double> axes, List<Boolean> buttons, boolean deadMan, long nanoTime) {
  /** Has no axes and no buttons, and allows no motion. */
  public static final Input NONE = new Input(List.of(), List.of(), false, 0);

  /** Checks the range of the axes. */
  public Input {
    axes = List.copyOf(axes);
    buttons = List.copyOf(buttons);
    for (double axis : axes) {
      // The negation refuses NaN as well.
      if (!(axis >= -1 && axis <= 1)) {
        throw new IllegalArgumentException("an axis must be -1 to 1, is " + axis);
      }
    }
  }

  /**
   * Gives an axis.
   *
   * @param index from 0
   * @return its deflection, -1 to 1; 0 if the device has no such axis
   */
  public double axis(int index) {
    return index < axes.size() ? axes.get(index) : 0;
  }

  /**
   * Says whether a button is pressed.
   *
   * @param index from 0
   * @return true if so; false if the device has no such button
   */
  public boolean button(int index) {
    return index < buttons.size() && buttons.get(index);
  }

  /**
   * Takes a dead zone out of the axes, and scales what remains: from 0 at the edge of the zone to
   * the scale at full deflection, without a jump.
   *
   * @param deadZone how far from the centre an axis still is at 0; 0 to less than 1
   * @param scale what full deflection gives; -1 to 1
   * @return the shaped input
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
