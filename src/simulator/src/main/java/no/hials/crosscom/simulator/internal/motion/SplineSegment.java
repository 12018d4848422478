package no.hials.crosscom.simulator.internal.motion;

import java.util.OptionalDouble;
import no.hials.crosscom.protocol.value.Frame;
import org.jspecify.annotations.Nullable;

/**
 * A segment of a spline block.
 *
 * @param shape its path
 * @param auxiliary a point of the circle; null for the other shapes
 * @param target the end of the TCP, in the robot's root at the start of the block
 * @param angle the angle on the circle, as for {@link MotionCommand.Circular}
 * @param rates the speed of the TCP
 * @param orientation the orientation on the path
 * @param external the end of the external axes
 */
public record SplineSegment(
    Shape shape,
    @Nullable Frame auxiliary,
    Frame target,
    OptionalDouble angle,
    PathRates rates,
    OrientationControl orientation,
    ExternalTarget external) {
  /** The paths of a segment. */
  public enum Shape {
    /** SLIN. */
    LINE,
    /** SCIRC. */
    CIRCLE,
    /** SPL. */
    THROUGH
  }
}
