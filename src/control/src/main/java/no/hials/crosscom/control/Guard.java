package no.hials.crosscom.control;

import java.math.BigDecimal;
import java.math.RoundingMode;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import org.jspecify.annotations.Nullable;

/** The limits of the position, and the messages of all violated limits. */
final class Guard {
  private static final String XYZ = "XYZ";
  private static final int SHOWN_DIGITS = 3;
  private static final double ROUNDING = 1e-9;

  private final Safety safety;
  private final AxisLimits axisLimits;
  private final @Nullable Workspace workspace;

  Guard(Safety safety, AxisLimits axisLimits, @Nullable Workspace workspace) {
    this.safety = safety;
    this.axisLimits = axisLimits;
    this.workspace = workspace;
  }

  /** Checks axes against the limits: actual positions without the margin, targets with it. */
  void check(Axis axes, boolean actual) throws ControlRefusedException {
    double margin = actual ? 0 : safety.axisMargin();
    for (int i = 0; i < 6; i++) {
      double minimum = axisLimits.minimum().get(i) + margin;
      double maximum = axisLimits.maximum().get(i) - margin;
      double angle = axes.get(i);
      if (angle < minimum || angle > maximum) {
        throw outside(
            StopKind.AXIS_LIMIT, "A" + (i + 1), "degrees", minimum, maximum, margin, angle, actual);
      }
    }
  }

  /**
   * Checks that the wrist is and stays far enough from its singularity for straight motions.
   *
   * @param a5 the position of A5
   * @param before its position at the last check; NaN if this is the first
   */
  void checkWrist(double a5, double before) throws ControlRefusedException {
    double margin = safety.wristMargin();
    // where it is at the next check, if it turns on
    double next = Double.isNaN(before) ? a5 : 2 * a5 - before;
    double nearest = a5 * next < 0 ? 0 : Math.min(Math.abs(a5), Math.abs(next));
    if (nearest < margin) {
      throw new ControlRefusedException(
          StopKind.SINGULARITY,
          "A5 must be at least "
              + number(margin)
              + " degrees from 0, where small motions of the tool turn A4 and A6 far, "
              + (Math.abs(a5) < margin ? "is " + number(a5) : "would be " + number(next))
              + ": move the axes first");
    }
  }

  /**
   * Checks a position against the workspace: actual positions without the margin, targets with it.
   */
  void check(Frame position, boolean actual) throws ControlRefusedException {
    if (workspace == null) {
      return;
    }
    double margin = actual ? 0 : safety.workspaceMargin();
    for (int i = 0; i < XYZ.length(); i++) {
      double minimum = workspace.min(i) + margin;
      double maximum = workspace.max(i) - margin;
      double place = i == 0 ? position.x() : i == 1 ? position.y() : position.z();
      if (place < minimum || place > maximum) {
        String name = XYZ.substring(i, i + 1) + " of the workspace";
        throw outside(StopKind.WORKSPACE, name, "mm", minimum, maximum, margin, place, actual);
      }
    }
  }

  private static ControlRefusedException outside(
      StopKind kind,
      String name,
      String unit,
      double minimum,
      double maximum,
      double margin,
      double value,
      boolean actual) {
    return new ControlRefusedException(
        kind,
        name
            + " must be "
            + number(minimum)
            + " to "
            + number(maximum)
            + " "
            + unit
            + (margin > 0 ? " (limits minus a margin of " + number(margin) + ")" : "")
            + (actual ? ", is " : ", would be ")
            + number(value));
  }

  /**
   * Checks a value against a limit, with a tolerance for rounding.
   *
   * @param words a pattern for the name, the limit, its unit and the value, formatted only if the
   *     limit is exceeded
   */
  static void checkAtMost(
      StopKind kind, String words, String name, double limit, String unit, double value)
      throws ControlRefusedException {
    if (value > limit * (1 + ROUNDING)) {
      throw new ControlRefusedException(
          kind, words.formatted(name, number(limit), unit, number(value)));
    }
  }

  static String number(double value) {
    return BigDecimal.valueOf(value)
        .setScale(SHOWN_DIGITS, RoundingMode.HALF_UP)
        .stripTrailingZeros()
        .toPlainString();
  }
}
