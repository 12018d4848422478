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
 * @param auxiliary the point on the way of a circle, else null
 * @param target the end, with those components that have a value. The type's name is missing if the
 *     statement has an aggregate without it
 * @param circularAngle {@code CA} in degrees; empty without it
 * @param approximations none for exact positioning
 * @param coordinates {@code #BASE} or {@code #TOOL} behind a relative motion, without {@code #} and
 *     in upper case; null without it
 * @param pointName the name of the variable that holds the target; empty for an aggregate
 * @param module the name of the module
 * @param position where the statement stands
 * @param triggers the triggers that wait for this motion
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
