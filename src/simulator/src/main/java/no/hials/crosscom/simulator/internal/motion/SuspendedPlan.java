package no.hials.crosscom.simulator.internal.motion;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A plan that an interrupt has suspended.
 *
 * @param axes the position where the robot left its path ({@code $AXIS_RET})
 * @param before the plan to which the robot was returning when it was interrupted again
 */
public record SuspendedPlan(
    Joints axes,
    PathCursor cursor,
    List<PathSegment> planned,
    Joints plannedEnd,
    @Nullable SuspendedPlan before) {
  public SuspendedPlan {
    planned = List.copyOf(planned);
  }
}
