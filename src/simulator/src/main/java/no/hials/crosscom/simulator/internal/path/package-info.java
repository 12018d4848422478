/**
 * Curves, their lengths, and the speeds along them: the mathematics of paths, without a robot.
 *
 * <p>A profile is the position on a path over time. The limits of a path change from point to
 * point.
 */
@NullMarked
package no.hials.crosscom.simulator.internal.path;

import org.jspecify.annotations.NullMarked;
