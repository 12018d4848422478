package no.hials.crosscom.simulator.internal.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.path.PathLimits;
import no.hials.crosscom.simulator.internal.path.Profile;
import org.jspecify.annotations.Nullable;

/**
 * A planned motion.
 *
 * @param motion the motion; null if the robot returns to a path that it has left
 * @param path the axes along it
 * @param limits the speeds along it, from where it starts
 * @param profile the position on the path, over time
 * @param problem the reason why it ends before its target, else null
 * @param overlap the time of the blend with the segment before, s; 0 to start from standstill
 * @param travel the external axes
 * @param corner the curve from the segment before, which the robot passes without a stop; else null
 */
record PathSegment(
    @Nullable MotionCommand motion,
    JointPath path,
    PathLimits limits,
    Profile profile,
    @Nullable MotionProblem problem,
    double overlap,
    Travel travel,
    @Nullable Corner corner) {
  PathSegment withOverlap(double seconds) {
    return new PathSegment(motion, path, limits, profile, problem, seconds, travel, corner);
  }

  PathSegment withProfile(Profile changed) {
    return new PathSegment(motion, path, limits, changed, problem, overlap, travel, corner);
  }

  /** Returns the segment with a curve before it, along which other limits hold. */
  PathSegment withCorner(@Nullable Corner curve, PathLimits changed) {
    return new PathSegment(motion, path, changed, profile, problem, overlap, travel, curve);
  }

  /** Returns the segment up to a position. */
  PathSegment until(double position) {
    return withCorner(corner, limits.between(limits.parameters()[0], position));
  }

  MotionCommand requireMotion() {
    return Objects.requireNonNull(motion);
  }

  double duration() {
    return profile.duration();
  }

  Axis at(double time) throws MotionRefusedException {
    double position = profile.position(time);
    return corner != null && position < corner.join()
        ? corner.path().at(corner.part(position))
        : path.at(position);
  }

  Axis external(double time) {
    double position = profile.position(time);
    return corner != null && position < corner.join()
        ? corner.external(position, travel)
        : travel.at(position);
  }

  /** Returns whether the robot has not passed the middle of the curve before the segment. */
  boolean isBefore(double time) {
    return corner != null && profile.position(time) < corner.middle();
  }

  Joints start() {
    return new Joints(path.start(), travel.start());
  }

  Joints end() {
    double last = path instanceof JointPath.OfTcp tcp ? tcp.sampler().lastParameter() : 1;
    return new Joints(path.end(), travel.at(last));
  }

  /**
   * Returns the points that the robot reaches: of a block the end of each segment, else its end.
   */
  List<Joints> points() {
    List<Joints> points = new ArrayList<>();
    double last = limits.parameters()[limits.parameters().length - 1];
    try {
      for (int point = 1; point < motionPoints(); point++) {
        double position = path.parameter(point);
        if (position < last) {
          points.add(new Joints(path.at(position), travel.at(position)));
        } else if (problem == null) {
          points.add(end()); // as the last point
        }
      }
    } catch (MotionRefusedException e) {
      // the path ends there
    }
    points.add(end());
    return points;
  }

  private int motionPoints() {
    if (motion instanceof MotionCommand.Spline spline) {
      return spline.segments().size();
    }
    return motion instanceof MotionCommand.AxisSpline spline ? spline.segments().size() : 1;
  }

  Axis near(double time) {
    return path.near(profile.position(time));
  }

  Frame tool() {
    return motion == null ? Frame.IDENTITY : motion.tool();
  }
}
