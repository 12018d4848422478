package no.hials.crosscom.simulator.internal.path;

import java.util.Arrays;

/**
 * The highest speeds and accelerations along a path.
 *
 * @param parameters points of the path, ascending
 * @param speeds the highest speed at each point, in the unit of the path/s
 * @param accelerations the highest acceleration at each point
 * @param stops the points at which the speed is 0
 */
@SuppressWarnings("ArrayRecordComponent") // neither compared nor changed
public record PathLimits(
    double[] parameters, double[] speeds, double[] accelerations, double[] stops) {
  public PathLimits(double[] parameters, double[] speeds, double[] accelerations) {
    this(parameters, speeds, accelerations, new double[0]);
  }

  public static PathLimits even(double length, double speed, double acceleration) {
    return new PathLimits(
        new double[] {0, length},
        new double[] {speed, speed},
        new double[] {acceleration, acceleration});
  }

  /** Returns the highest acceleration between a point and the next. */
  public double acceleration(int interval) {
    return Math.min(accelerations[interval], accelerations[interval + 1]);
  }

  /** Returns the highest speed at one end of an interval that follows from that at the other. */
  public double reached(int interval, double speed) {
    double distance = parameters[interval + 1] - parameters[interval];
    return Math.sqrt(speed * speed + 2 * acceleration(interval) * distance);
  }

  /** Returns the limits of a part of the path. */
  public PathLimits between(double from, double to) {
    PathLimits begun = with(from);
    PathLimits both = begun.with(to);
    int first = Arrays.binarySearch(both.parameters, from);
    int last = Arrays.binarySearch(both.parameters, to);
    return new PathLimits(
        Arrays.copyOfRange(both.parameters, first, last + 1),
        Arrays.copyOfRange(both.speeds, first, last + 1),
        Arrays.copyOfRange(both.accelerations, first, last + 1),
        Arrays.stream(stops).filter(stop -> stop >= from && stop <= to).toArray());
  }

  /** Adds a point at which the speed is 0. */
  public PathLimits withStop(double parameter) {
    PathLimits all = with(parameter);
    double[] more = Arrays.copyOf(stops, stops.length + 1);
    more[stops.length] = parameter;
    return new PathLimits(all.parameters, all.speeds, all.accelerations, more);
  }

  /** Returns the highest speeds of a profile, which starts at one. */
  public double[] highest(double start) {
    double[] highest = speeds.clone();
    for (double stop : stops) {
      highest[Arrays.binarySearch(parameters, stop)] = 0;
    }
    highest[0] = start;
    return highest;
  }

  /** Lowers the speed between two points. */
  public PathLimits lowered(double from, double to, double speed) {
    PathLimits all = with(from).with(to);
    double[] lower = all.speeds.clone();
    int first = Arrays.binarySearch(all.parameters, from);
    int last = Arrays.binarySearch(all.parameters, to);
    for (int i = first; i <= last; i++) {
      lower[i] = Math.min(lower[i], speed);
    }
    return new PathLimits(all.parameters, lower, all.accelerations, stops);
  }

  /** Adds a point, at which the limits of the interval around it hold. */
  public PathLimits with(double parameter) {
    int found = Arrays.binarySearch(parameters, parameter);
    if (found >= 0) {
      return this;
    }
    int at = -found - 1;
    int before = Math.max(0, at - 1);
    int after = Math.min(parameters.length - 1, at);
    return new PathLimits(
        inserted(parameters, at, parameter),
        inserted(speeds, at, Math.min(speeds[before], speeds[after])),
        inserted(accelerations, at, Math.min(accelerations[before], accelerations[after])),
        stops);
  }

  private static double[] inserted(double[] values, int at, double value) {
    double[] longer = new double[values.length + 1];
    System.arraycopy(values, 0, longer, 0, at);
    longer[at] = value;
    System.arraycopy(values, at, longer, at + 1, values.length - at);
    return longer;
  }

  /** Adds a path before this one, whose points end where this one starts. */
  public PathLimits after(PathLimits first) {
    int last = first.parameters.length - 1;
    double[] joined = joined(first.speeds, speeds);
    joined[last] = Math.min(first.speeds[last], speeds[0]);
    double[] ramps = joined(first.accelerations, accelerations);
    ramps[last] = Math.min(first.accelerations[last], accelerations[0]);
    double[] allStops = Arrays.copyOf(first.stops, first.stops.length + stops.length);
    System.arraycopy(stops, 0, allStops, first.stops.length, stops.length);
    return new PathLimits(joined(first.parameters, parameters), joined, ramps, allStops);
  }

  private static double[] joined(double[] first, double[] second) {
    double[] both = Arrays.copyOf(first, first.length + second.length - 1);
    System.arraycopy(second, 0, both, first.length - 1, second.length);
    return both;
  }

  /** Returns the same limits with other parameters: moved by an offset after scaling. */
  public PathLimits scaled(double factor, double offset) {
    return new PathLimits(
        Arrays.stream(parameters).map(value -> offset + value * factor).toArray(),
        Arrays.stream(speeds).map(value -> value * factor).toArray(),
        Arrays.stream(accelerations).map(value -> value * factor).toArray(),
        Arrays.stream(stops).map(value -> offset + value * factor).toArray());
  }
}
