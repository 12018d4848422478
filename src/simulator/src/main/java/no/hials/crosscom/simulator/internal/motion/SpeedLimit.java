package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.protocol.value.Axis;

/**
 * The highest speed of the robot in a cycle, whatever is planned: lower in mode T1.
 *
 * @param path the highest speed of TCP and flange, m/s
 * @param axes the part of each axis' highest speed, %
 */
public record SpeedLimit(double path, Axis axes) {
  /** No limit but the speeds of the axes. */
  public static final SpeedLimit NONE =
      new SpeedLimit(Double.POSITIVE_INFINITY, new Axis(100, 100, 100, 100, 100, 100));
}
