package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import org.jspecify.annotations.Nullable;

/**
 * The accelerations that a cycle must not exceed.
 *
 * @param axes those of the axes, degrees/s²
 * @param path those of the TCP on a LIN or CIRC, else null
 * @param tool the TCP
 */
record AccelerationLimits(Axis axes, @Nullable PathRates path, Frame tool) {
  /** Returns the limits of the current segment; in a blend the higher of both. */
  static AccelerationLimits of(PathSegment segment, @Nullable PathSegment next) {
    AccelerationLimits limits = of(segment);
    return next == null ? limits : limits.orHigher(of(next));
  }

  /** Limits the axes only by their highest accelerations, whatever the program has set. */
  AccelerationLimits withoutPath(Axis most) {
    return new AccelerationLimits(most, null, tool);
  }

  private static AccelerationLimits of(PathSegment segment) {
    PathRates path = segment.path() instanceof JointPath.OfTcp tcp ? tcp.rates() : null;
    return new AccelerationLimits(segment.path().accelerations(), path, segment.tool());
  }

  private AccelerationLimits orHigher(AccelerationLimits other) {
    boolean samePath = path != null && other.path != null && tool.equals(other.tool);
    return new AccelerationLimits(
        higher(axes, other.axes), samePath ? higher(path, other.path) : null, tool);
  }

  private static @Nullable PathRates higher(@Nullable PathRates one, @Nullable PathRates other) {
    return one == null || other == null
        ? null
        : new PathRates(
            Math.max(one.velocity(), other.velocity()),
            Math.max(one.acceleration(), other.acceleration()),
            Math.max(one.turnVelocity(), other.turnVelocity()),
            Math.max(one.turnAcceleration(), other.turnAcceleration()));
  }

  private static Axis higher(Axis one, Axis other) {
    double[] six = one.toArray();
    for (int axis = 0; axis < six.length; axis++) {
      six[axis] = Math.max(six[axis], other.get(axis));
    }
    return Axis.of(six);
  }
}
