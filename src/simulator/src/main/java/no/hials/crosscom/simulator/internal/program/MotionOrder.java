package no.hials.crosscom.simulator.internal.program;

import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.Statement.Approximation;
import no.hials.crosscom.lang.Statement.MotionKind;
import no.hials.crosscom.protocol.value.KrlStruct;
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
    List<TriggerOrder> triggers) {}
