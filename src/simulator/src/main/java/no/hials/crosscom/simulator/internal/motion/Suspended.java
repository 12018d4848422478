package no.hials.crosscom.simulator.internal.motion;

import java.util.List;
import no.hials.crosscom.kinematics.Axes;
import org.jspecify.annotations.Nullable;

/** Keeps the plan that an interrupt has put aside, and where the robot left its path. */
public final class Suspended {
  private final Axes axes;
  private final Cursor cursor;
  private final List<Leg> planned;
  private final Axes plannedEnd;
  private final @Nullable Suspended before;

  Suspended(
      Axes axes, Cursor cursor, List<Leg> planned, Axes plannedEnd, @Nullable Suspended before) {
    this.axes = axes;
    this.cursor = cursor;
    this.planned = List.copyOf(planned);
    this.plannedEnd = plannedEnd;
    this.before = before;
  }

  /**
   * Gives where the robot left its path ({@code $AXIS_RET}).
   *
   * @return the axes
   */
  public Axes axes() {
    return axes;
  }

  Cursor cursor() {
    return cursor;
  }

  List<Leg> planned() {
    return planned;
  }

  Axes plannedEnd() {
    return plannedEnd;
  }

  /** Gives the plan to which the robot was going back when it was interrupted again. */
  @Nullable Suspended before() {
    return before;
  }
}
