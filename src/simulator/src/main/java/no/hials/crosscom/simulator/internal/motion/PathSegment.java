package no.hials.crosscom.simulator.internal.motion;

import java.util.Objects;
import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.kinematics.Frame;
import org.jspecify.annotations.Nullable;

/**
 * A motion as it is planned.
 *
 * @param motion the motion; none if the robot goes back to a path that it has left
 * @param path where it leads
 * @param profile how far it is on the path, over time
 * @param problem why it ends before its target
 * @param overlap how long it blends with the segment before, s; 0 to start from standing
 */
record PathSegment(
    @Nullable MotionCommand motion,
    JointPath path,
    Profile profile,
    @Nullable MotionProblem problem,
    double overlap) {
  PathSegment withOverlap(double seconds) {
    return new PathSegment(motion, path, profile, problem, seconds);
  }

  /** Gives the motion of a segment that has one. */
  MotionCommand requireMotion() {
    return Objects.requireNonNull(motion);
  }

  double duration() {
    return profile.duration();
  }

  Axes at(double time) throws NoPointException {
    return path.at(profile.position(time));
  }

  Axes near(double time) {
    return path.near(profile.position(time));
  }

  Frame tool() {
    return motion == null ? Frame.IDENTITY : motion.tool();
  }
}
