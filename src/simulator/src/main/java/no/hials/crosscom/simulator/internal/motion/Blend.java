package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.kinematics.Frame;
import no.hials.crosscom.simulator.internal.motion.Approximation.AxisDistance;
import no.hials.crosscom.simulator.internal.motion.Approximation.Distance;
import no.hials.crosscom.simulator.internal.motion.Approximation.Orientation;
import no.hials.crosscom.simulator.internal.motion.Approximation.Speed;

/**
 * The sum of two legs: what is left of the one and what is done of the next add up, of the TCP if
 * both are paths of the same one, of the axes otherwise.
 */
final class Blend {
  /** {@code $APO_DIS_PTP}, degrees, of which C_PTP is a part (krl.md 2.7: 90 for every axis). */
  private static final double AXIS_DISTANCE = 90;

  /** So exactly the time is found at which a distance is kept: halvings of the longest time. */
  private static final int HALVINGS = 20;

  /** The points at which a blend is tried. */
  private static final int TRIALS = 4;

  private final Arm arm;

  Blend(Arm arm) {
    this.arm = arm;
  }

  /** Finds the axes where a cursor is. */
  Axes axes(Cursor at) throws NoPointException {
    return arm.clamped(unlimited(at));
  }

  private Axes unlimited(Cursor at) throws NoPointException {
    Leg leg = at.requireLeg();
    Leg next = at.next();
    if (next == null) {
      return leg.at(at.time());
    }
    if (leg.path() instanceof Path.OfTcp from
        && next.path() instanceof Path.OfTcp to
        && from.byPose()
        && to.byPose()
        && from.tool().equals(to.tool())) {
      Frame first = from.curve().at(leg.profile().position(at.time()));
      Frame second = to.curve().at(next.profile().position(at.nextTime()));
      Axes near = sum(leg.near(at.time()), next.near(at.nextTime()), to.start());
      Frame tcp = sum(first, second, to.curve().at(0));
      return arm.inverse(tcp, from.flangeInTool(), near);
    }
    return sum(leg.at(at.time()), next.at(at.nextTime()), next.path().start());
  }

  private static Axes sum(Axes first, Axes second, Axes corner) {
    return first.plus(second.minus(corner));
  }

  private static Frame sum(Frame first, Frame second, Frame corner) {
    Point position = Point.of(first).plus(Point.of(second).minus(Point.of(corner)));
    Frame turn = turn(second).times(turn(corner).inverse()).times(turn(first));
    return position.turnedAs(turn);
  }

  private static Frame turn(Frame frame) {
    return new Frame(0, 0, 0, frame.a(), frame.b(), frame.c());
  }

  /** Finds how long a leg may blend with the one before, s; 0 if not at all. */
  double overlap(Leg leg, Leg next) {
    double longest = Math.min(leg.profile().rampDown(), next.profile().rampUp());
    if (leg.motion() == null || leg.problem() != null || longest == 0) {
      return 0;
    }
    double overlap = kept(leg.motion().approximation(), leg, next, longest);
    return isPassable(leg, next, overlap) ? overlap : 0;
  }

  private double kept(Approximation approximation, Leg leg, Leg next, double longest) {
    if (approximation instanceof Speed speed) {
      return Math.min(longest, leg.profile().rampDown() * speed.percent() / 100);
    }
    if (isKept(approximation, leg, next, longest)) {
      return longest;
    }
    double kept = 0;
    double step = longest;
    for (int i = 0; i < HALVINGS; i++) {
      step /= 2;
      if (isKept(approximation, leg, next, kept + step)) {
        kept += step;
      }
    }
    return kept;
  }

  /** Says whether a blend is near enough to the corner, where it begins and where it ends. */
  private boolean isKept(Approximation approximation, Leg leg, Leg next, double overlap) {
    try {
      double begin = leg.duration() - overlap;
      if (approximation instanceof AxisDistance ptp) {
        double most = ptp.percent() / 100 * AXIS_DISTANCE;
        return leg.path().end().largestDifference(leg.at(begin)) <= most
            && next.path().start().largestDifference(next.at(overlap)) <= most;
      }
      Frame first = tcp(leg, begin, leg.tool());
      Frame corner = tcp(leg, leg.duration(), leg.tool());
      Frame second = tcp(next, overlap, leg.tool());
      if (approximation instanceof Distance distance) {
        return first.distance(corner) <= distance.mm() && second.distance(corner) <= distance.mm();
      }
      return approximation instanceof Orientation orientation
          && first.angle(corner) <= orientation.degrees()
          && second.angle(corner) <= orientation.degrees();
    } catch (NoPointException e) {
      return false;
    }
  }

  private Frame tcp(Leg leg, double time, Frame tool) throws NoPointException {
    return leg.path() instanceof Path.OfTcp path && path.byPose() && path.tool().equals(tool)
        ? path.curve().at(leg.profile().position(time))
        : arm.tcp(leg.at(time), tool);
  }

  /** Says whether the arm can go all the way through a blend: a corner may be out of its reach. */
  private boolean isPassable(Leg leg, Leg next, double overlap) {
    try {
      for (int i = 1; i < TRIALS; i++) {
        double time = overlap * i / TRIALS;
        Cursor at = new Cursor(leg, leg.duration() - overlap + time, next, time);
        if (arm.beyondLimit(unlimited(at)).isPresent()) {
          return false;
        }
      }
      return true;
    } catch (NoPointException e) {
      return false;
    }
  }
}
