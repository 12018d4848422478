package no.hials.crosscom.simulator.internal.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import no.hials.crosscom.simulator.internal.path.Profile;
import no.hials.crosscom.simulator.internal.path.SampledProfile;
import org.jspecify.annotations.Nullable;

/**
 * The segments from the robot on, at one moment: the last one that has started, and the planned
 * ones.
 *
 * @param running the last one that has started; null if the robot is between motions
 * @param time the time since its start, s
 * @param planned those that have not started
 */
record PlannedPath(@Nullable PathSegment running, double time, List<PathSegment> planned) {
  /** How much faster than planned the first speed may be, so that rounding does not matter. */
  private static final double TOLERANCE = 1 + 1e-6;

  /** The part of the rest of a segment before which the robot cannot leave it any more. */
  private static final double AHEAD = 0.01;

  /**
   * A place on a segment.
   *
   * @param index the index of the segment in {@link #planned}; -1 for the running one
   * @param position the position on it
   */
  record Place(int index, double position) {}

  @Nullable PathSegment segment(int index) {
    return index < 0 ? running : index < planned.size() ? planned.get(index) : null;
  }

  /** Returns the last segment; null without one. */
  @Nullable PathSegment last() {
    return segment(planned.size() - 1);
  }

  /** Returns the first position at which the robot can still leave the running segment. */
  double earliestLeave() {
    double position = running == null ? 0 : running.profile().position(time);
    return position + (1 - position) * AHEAD;
  }

  /** Returns the same path with another segment, or with one more. */
  PlannedPath with(int index, PathSegment changed) {
    if (index < 0) {
      return new PlannedPath(changed, time, planned);
    }
    List<PathSegment> all = new ArrayList<>(planned);
    if (index == all.size()) {
      all.add(changed);
    } else {
      all.set(index, changed);
    }
    return new PlannedPath(running, time, all);
  }

  /**
   * Plans the speeds again of the segments that are passed without a stop before and after one.
   *
   * @param later how much later than now the speeds change, s
   * @return empty if the robot is too fast or too far for the limits
   */
  Optional<PlannedPath> replanned(int index, double later) {
    int first = index;
    while (first >= 0 && planned.get(first).corner() != null) {
      first--;
    }
    int last = index;
    while (last + 1 < planned.size() && planned.get(last + 1).corner() != null) {
      last++;
    }
    List<PathSegment> chain = new ArrayList<>();
    for (int i = first; i <= last; i++) {
      PathSegment segment = segment(i);
      if (segment == null) {
        return Optional.empty();
      }
      chain.add(segment);
    }
    PathSegment begun = chain.get(0);
    double change = time + later;
    double speed = 0;
    if (first < 0) {
      double[] parameters = begun.limits().parameters();
      double position = begun.profile().position(change);
      double end = parameters[parameters.length - 1];
      if (position >= end) {
        return Optional.empty();
      }
      speed = begun.profile().speed(change);
      chain.set(0, begun.withCorner(begun.corner(), begun.limits().between(position, end)));
    }
    List<Profile> profiles = profiles(chain, speed).orElse(null);
    if (profiles == null) {
      return Optional.empty();
    }
    PlannedPath path = this;
    for (int i = first; i <= last; i++) {
      Profile profile = profiles.get(i - first);
      if (i < 0) {
        profile = new Profile.Changed(begun.profile(), change, profile);
      }
      path = path.with(i, chain.get(i - first).withProfile(profile));
    }
    return Optional.of(path);
  }

  /**
   * Plans the fastest profiles from a speed to standstill.
   *
   * @param segments the segments; the limits of the first start where the robot is
   * @param speed the speed at the start of the first
   * @return empty if the robot cannot slow down to the limits
   */
  private static Optional<List<Profile>> profiles(List<PathSegment> segments, double speed) {
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

  /** Returns the time from now until the robot is at a place, s; negative if it has passed it. */
  double timeTo(Place place) {
    double start = -time;
    for (int i = -1; i < place.index(); i++) {
      PathSegment segment = segment(i);
      PathSegment next = segment(i + 1);
      double overlap = next == null ? 0 : next.overlap();
      start = segment == null ? 0 : start + segment.duration() - overlap;
    }
    PathSegment of = segment(place.index());
    return of == null ? start : start + of.profile().time(place.position());
  }

  /**
   * Finds a place of a motion. An approximated point is the middle of its approximation. Before the
   * start of the motion its start counts; after its end the path continues with the next motion.
   *
   * @return empty if it is not planned, or no longer
   */
  Optional<Place> find(long motion, PathPoint at, PathLengths lengths)
      throws MotionRefusedException {
    for (int i = -1; i < planned.size(); i++) {
      PathSegment segment = segment(i);
      if (segment == null) {
        continue;
      }
      Corner corner = segment.corner();
      if (corner != null && isOf(motion, corner.before())) {
        return Optional.of(find(i, segment, corner, at, lengths));
      }
      if (isOf(motion, segment)) {
        return find(i, segment, at, lengths);
      }
    }
    return Optional.empty();
  }

  /** Finds a place of a motion whose end has become the corner before a segment. */
  private Place find(
      int index, PathSegment segment, Corner corner, PathPoint at, PathLengths lengths)
      throws MotionRefusedException {
    PathSegment before = corner.before();
    double point = before.path().parameter(at.point());
    double beyond = at.mm() > 0 ? at.mm() - lengths.length(before, point) : -1;
    if (beyond > 0) {
      return within(index, corner, lengths.fromStart(segment, beyond));
    }
    return new Place(index, corner.positionOf(lengths.position(before, point, at.mm())));
  }

  private static Place within(int index, @Nullable Corner corner, double position) {
    return new Place(
        index,
        corner != null && position < corner.join()
            ? corner.position((1 + position / corner.join()) / 2)
            : position);
  }

  private static boolean isOf(long motion, PathSegment segment) {
    return segment.motion() != null && segment.motion().id() == motion;
  }

  private Optional<Place> find(int index, PathSegment segment, PathPoint at, PathLengths lengths)
      throws MotionRefusedException {
    double point = segment.path().parameter(at.point());
    PathSegment next = segment(index + 1);
    double beyond = at.mm() > 0 ? at.mm() - lengths.length(segment, point) : -1;
    if (beyond > 0) {
      return next == null
          ? Optional.empty()
          : find(index + 1, next, new PathPoint(0, beyond), lengths);
    }
    double position = lengths.position(segment, point, at.mm());
    Corner follows = next == null ? null : next.corner();
    if (follows != null && position > follows.leave()) {
      return Optional.of(new Place(index + 1, follows.positionOf(position)));
    }
    if (next != null && next.overlap() > 0) {
      double middle = segment.profile().position(segment.duration() - next.overlap() / 2);
      position = Math.min(position, middle);
    }
    return Optional.of(within(index, segment.corner(), position));
  }

  /**
   * Plans a stop at a place of a motion; null if the robot cannot stop there any more.
   *
   * @param later how much later than now the speeds change, s
   */
  @Nullable PlannedPath stopping(long motion, PathPoint at, double later, PathLengths lengths) {
    try {
      PlannedPath.Place place = find(motion, at, lengths).orElse(null);
      PathSegment segment = place == null ? null : segment(place.index());
      if (place == null || segment == null) {
        return null;
      }
      double[] parameters = segment.limits().parameters();
      double position = place.position();
      if (position <= parameters[0] || position >= parameters[parameters.length - 1]) {
        // the robot stands there anyway
        return timeTo(place) > later ? this : null;
      }
      if (timeTo(place) <= later) {
        return null;
      }
      PathSegment stopping =
          segment.withCorner(segment.corner(), segment.limits().withStop(position));
      return with(place.index(), stopping).replanned(place.index(), later).orElse(null);
    } catch (MotionRefusedException e) {
      return null;
    }
  }
}
