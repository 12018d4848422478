package no.hials.crosscom.simulator.internal.program;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.Statement.Approximation;
import no.hials.crosscom.lang.Statement.MotionKind;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.internal.motion.PathPoint;
import org.jspecify.annotations.Nullable;

/**
 * A motion statement with its values.
 *
 * @param kind the kind of motion
 * @param auxiliary the auxiliary point of a circle, else null
 * @param target the target, with the components that have a value; without a type name if the
 *     statement has an aggregate without one
 * @param circularAngle {@code CA} in degrees; empty without it
 * @param approximations empty for exact positioning
 * @param coordinates {@code #BASE} or {@code #TOOL} after a relative motion, without {@code #} and
 *     in upper case; null without it
 * @param pointName the name of the variable of the target; empty for an aggregate
 * @param module the name of the module
 * @param position the position of the statement
 * @param triggers the triggers of this motion
 * @param stops where it stops under a condition
 * @param form whether it is a plain or a spline motion, or an SPL segment
 * @param settings the values of system variables that hold for this motion only; empty for the
 *     present ones
 * @param block the segments if it is a spline block, else null
 */
public record MotionOrder(
    MotionKind kind,
    @Nullable KrlStruct auxiliary,
    KrlStruct target,
    OptionalDouble circularAngle,
    Set<Approximation> approximations,
    @Nullable String coordinates,
    String pointName,
    String module,
    Position position,
    List<TriggerOrder> triggers,
    List<Stop> stops,
    Form form,
    Map<String, KrlValue> settings,
    @Nullable BlockOrder block) {
  /**
   * A {@code STOP WHEN PATH} with its values.
   *
   * @param at where the robot stops
   * @param condition the condition, to evaluate by {@link KrlInterpreter#isTrue}
   * @param owner the frame whose variables it uses
   */
  public record Stop(PathPoint at, CompiledCode condition, CallFrame owner) {}

  /** The forms of a motion. */
  public enum Form {
    /** PTP, LIN, CIRC. */
    PLAIN,
    /** SPTP, SLIN, SCIRC, or a block. */
    SPLINE,
    /** SPL: a segment that only passes through its point. */
    THROUGH
  }

  /** Creates the order of a motion that is not a spline motion. */
  public MotionOrder(
      MotionKind kind,
      @Nullable KrlStruct auxiliary,
      KrlStruct target,
      OptionalDouble circularAngle,
      Set<Approximation> approximations,
      @Nullable String coordinates,
      String pointName,
      String module,
      Position position,
      List<TriggerOrder> triggers) {
    this(
        kind,
        auxiliary,
        target,
        circularAngle,
        approximations,
        coordinates,
        pointName,
        module,
        position,
        triggers,
        List.of(),
        Form.PLAIN,
        Map.of(),
        null);
  }

  /** Returns whether it is a spline motion. */
  public boolean spline() {
    return form != Form.PLAIN;
  }

  /** Returns the same motion of another kind and with other approximations. */
  public MotionOrder with(MotionKind newKind, Set<Approximation> newApproximations) {
    return new MotionOrder(
        newKind,
        auxiliary,
        target,
        circularAngle,
        newApproximations,
        coordinates,
        pointName,
        module,
        position,
        triggers,
        stops,
        form,
        settings,
        block);
  }
}
