package no.hials.crosscom.simulator.internal.motion;

import java.util.function.DoubleFunction;
import no.hials.crosscom.protocol.value.Axis;
import org.jspecify.annotations.Nullable;

/**
 * The way of the external axes in a motion: even along its path, whatever that is.
 *
 * @param start E1 to E6 at the start of the path
 * @param end E1 to E6 at its end
 * @param speed the highest speed of the motion, in paths/s
 * @param acceleration its highest acceleration, in paths/s²
 * @param curve the axes over the path if they do not move evenly, else null
 */
record Travel(
    Axis start, Axis end, double speed, double acceleration, @Nullable DoubleFunction<Axis> curve) {
  /** Returns a way that is not even; the limits of its path are those of the axes too. */
  static Travel along(Axis start, Axis end, DoubleFunction<Axis> curve) {
    return new Travel(start, end, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, curve);
  }

  static Travel of(ExternalAxes axes, Axis start, ExternalTarget target) {
    double speed = Double.POSITIVE_INFINITY;
    double acceleration = Double.POSITIVE_INFINITY;
    for (int i = 0; i < axes.count(); i++) {
      double way = Math.abs(target.axes().get(i) - start.get(i));
      ExternalAxes.Limits limits = axes.limits().get(i);
      speed = Math.min(speed, limits.speed() * target.rates().velocity().get(i) / 100 / way);
      double most = limits.acceleration() * target.rates().acceleration().get(i) / 100;
      acceleration = Math.min(acceleration, most / way);
    }
    return new Travel(start, target.axes(), speed, acceleration, null);
  }

  boolean isNone() {
    return curve == null && start.equals(end);
  }

  Axis at(double parameter) {
    if (curve != null) {
      return curve.apply(parameter);
    }
    if (isNone() || parameter == 0) {
      return start;
    }
    double[] six = start.toArray();
    for (int i = 0; i < six.length; i++) {
      six[i] += parameter * (end.get(i) - start.get(i));
    }
    return parameter == 1 ? end : Axis.of(six);
  }
}
