package no.hials.crosscom.simulator.internal.program;

import no.hials.crosscom.simulator.internal.motion.PathPoint;

/**
 * A {@code STOP WHEN PATH} with its values.
 *
 * @param at where the robot stops
 * @param condition the condition, to evaluate by {@link KrlInterpreter#isTrue}
 * @param owner the frame whose variables it uses
 */
public record StopOrder(PathPoint at, CompiledCode condition, CallFrame owner) {}
