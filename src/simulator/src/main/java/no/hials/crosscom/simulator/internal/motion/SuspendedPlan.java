package no.hials.crosscom.simulator.internal.motion;

import java.util.List;
import no.hials.crosscom.kinematics.Axes;
import org.jspecify.annotations.Nullable;

/** A plan that an interrupt has put aside, and the position where the robot left its path. */
public final class SuspendedPlan {
  private final Axes axes;
  private final PathCursor cursor;
  private final List<PathSegment> planned;
  private final Axes plannedEnd;
  private final @Nullable SuspendedPlan before;

  SuspendedPlan(
      Axes axes,
      PathCursor cursor,
      List<PathSegment> planned,
      Axes plannedEnd,
      @Nullable SuspendedPlan before) {
    this.axes = axes;
    this.cursor = cursor;
    this.planned = List.copyOf(planned);
    this.plannedEnd = plannedEnd;
    this.before = before;
  }

  /** Returns the axes where the robot left its path ({@code $AXIS_RET}). */
  public Axes axes() {
    return axes;
  }

  PathCursor cursor() {
    return cursor;
  }

  List<PathSegment> planned() {
    return planned;
  }

  Axes plannedEnd() {
    return plannedEnd;
  }

  /** Returns the plan to which the robot was returning when it was interrupted again. */
  @Nullable SuspendedPlan before() {
    return before;
  }
}
