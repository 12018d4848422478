package no.hials.crosscom.lang;

import no.hials.crosscom.lang.Statement.SplineKind;
import org.jspecify.annotations.Nullable;

/** The statements that a spline block can contain (docs/reference/krl-language.md#splines). */
final class SplineRules {
  private SplineRules() {}

  /**
   * Returns the error of a statement outside a spline block, as the end of a sentence that begins
   * with the statement; null if nothing is.
   */
  static @Nullable String outside(Statement statement) {
    boolean onlyInside =
        statement instanceof Statement.TimeBlock
            || statement instanceof Statement.ConstantVelocity
            || (statement instanceof Statement.SplineMotion motion
                && (motion.kind() == SplineKind.SPL || motion.kind() == SplineKind.SPL_REL));
    return onlyInside ? " is allowed only in a spline block" : null;
  }

  /**
   * Returns the error of a statement in a spline block; null if there is none.
   *
   * @param pointToPoint whether the block is a {@code PTP_SPLINE}
   */
  static @Nullable String inside(Statement statement, boolean pointToPoint) {
    if (!(statement instanceof Statement.SplineElement)) {
      return " is not allowed in a spline block";
    }
    boolean fits =
        statement instanceof Statement.SplineMotion motion
            ? motion.kind().pointToPoint() == pointToPoint
            : !pointToPoint || !(statement instanceof Statement.ConstantVelocity);
    return fits ? null : " is not allowed in a " + (pointToPoint ? "PTP_SPLINE" : "SPLINE");
  }
}
