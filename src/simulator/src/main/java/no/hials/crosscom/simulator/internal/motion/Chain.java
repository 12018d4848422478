package no.hials.crosscom.simulator.internal.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The profiles of segments that follow each other through corners, without a stop. */
final class Chain {
  /** How much faster than planned the first speed may be, so that rounding does not matter. */
  private static final double TOLERANCE = 1 + 1e-6;

  private Chain() {}

  /**
   * Plans the fastest profiles from a speed to standstill.
   *
   * @param segments the segments; the limits of the first start where the robot is
   * @param speed the speed at the start of the first
   * @return empty if the robot cannot slow down to the limits
   */
  static Optional<List<Profile>> plan(List<PathSegment> segments, double speed) {
    List<double[]> speeds = new ArrayList<>();
    for (PathSegment segment : segments) {
      speeds.add(segment.limits().highest(segment.limits().speeds()[0]));
    }
    forward(segments, speeds, speed);
    backward(segments, speeds);
    double[] first = speeds.get(0);
    if (speed > first[0] * TOLERANCE) {
      return Optional.empty();
    }
    first[0] = speed;
    List<Profile> profiles = new ArrayList<>();
    for (int i = 0; i < speeds.size(); i++) {
      profiles.add(SampledProfile.through(segments.get(i).limits(), speeds.get(i), 0));
    }
    return Optional.of(profiles);
  }

  private static void forward(List<PathSegment> segments, List<double[]> speeds, double speed) {
    double enter = speed;
    for (int i = 0; i < speeds.size(); i++) {
      double[] of = speeds.get(i);
      double entry = entry(segments.get(i), i);
      // the robot may be at a speed that the limits between two points do not allow
      of[0] = i == 0 ? enter : Math.min(of[0], enter / entry);
      SampledProfile.reachForward(segments.get(i).limits(), of);
      enter = of[of.length - 1];
    }
  }

  private static void backward(List<PathSegment> segments, List<double[]> speeds) {
    double leave = 0;
    for (int i = speeds.size() - 1; i >= 0; i--) {
      double[] of = speeds.get(i);
      of[of.length - 1] = Math.min(of[of.length - 1], leave);
      SampledProfile.reachBackward(segments.get(i).limits(), of);
      leave = of[0] * entry(segments.get(i), i);
    }
  }

  private static double entry(PathSegment segment, int index) {
    Corner corner = segment.corner();
    return index == 0 || corner == null ? 1 : corner.entry();
  }
}
