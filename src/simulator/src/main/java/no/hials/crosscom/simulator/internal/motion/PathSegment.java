package no.hials.crosscom.simulator.internal.motion;

import java.util.Objects;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import org.jspecify.annotations.Nullable;

/**
 * A planned motion.
 *
 * @param motion the motion; null if the robot returns to a path that it has left
 * @param path the axes along it
 * @param profile the position on the path, over time
 * @param problem the reason why it ends before its target, else null
 * @param overlap the time of the blend with the segment before, s; 0 to start from standstill
 * @param travel the external axes
 */
record PathSegment(
    @Nullable MotionCommand motion,
    JointPath path,
    Profile profile,
    @Nullable MotionProblem problem,
    double overlap,
    Travel travel) {
  PathSegment withOverlap(double seconds) {
    return new PathSegment(motion, path, profile, problem, seconds, travel);
  }

  MotionCommand requireMotion() {
    return Objects.requireNonNull(motion);
  }

  double duration() {
    return profile.duration();
  }

  Axis at(double time) throws MotionRefusedException {
    return path.at(profile.position(time));
  }

  Axis external(double time) {
    return travel.at(profile.position(time));
  }

  Joints start() {
    return new Joints(path.start(), travel.start());
  }

  Joints end() {
    return new Joints(path.end(), external(duration()));
  }

  Axis near(double time) {
    return path.near(profile.position(time));
  }

  Frame tool() {
    return motion == null ? Frame.IDENTITY : motion.tool();
  }
}
