package no.hials.crosscom.web.internal.jog;

import static no.hials.crosscom.kinematics.Frames.inverse;
import static no.hials.crosscom.kinematics.Frames.product;

import no.hials.crosscom.control.DriveSpace;
import no.hials.crosscom.control.State;
import no.hials.crosscom.control.Twist;
import no.hials.crosscom.protocol.value.Frame;

/**
 * A motion of one step: as fast as the press allows, and slower towards its end.
 *
 * @param space the coordinates
 * @param press the press with its step
 * @param start the state of the robot at the beginning
 */
record JogStep(DriveSpace space, Press press, State start) {
  /** The remaining distance that counts as zero, mm or degrees. */
  static final double TOLERANCE = 0.01;

  /**
   * The speed for a remaining distance, 1/s, with increments of full length. The robot shows a
   * command two or three steps of its program later, so that a higher rate would move it too far.
   */
  private static final double RATE = 10;

  /** Returns the deflection, 0 to 1; 0 at the end of the step. */
  double deflection(State now, double fullSpeed) {
    double remaining = press.step() - press.signed(moved(now));
    if (remaining <= TOLERANCE) {
      return 0;
    }
    // with shorter increments the rate can be higher by as much; at an override of 0 there are none
    double rate = RATE / Math.max(0.1, now.incrementFactor());
    return Math.min(press.speed(), remaining * rate / fullSpeed);
  }

  /** Returns the distance from the start in the direction of the press. */
  private double moved(State now) {
    int direction = press.direction();
    if (space == DriveSpace.JOINTS) {
      return now.axes().get(direction) - start.axes().get(direction);
    }
    Twist way = Twist.between(start.position(), now.position());
    Frame linear = inStart(way.x(), way.y(), way.z());
    Frame turn = inStart(way.aboutX(), way.aboutY(), way.aboutZ());
    return switch (direction) {
      case 0 -> linear.x();
      case 1 -> linear.y();
      case 2 -> linear.z();
      // A is about Z, C about X
      case 3 -> turn.z();
      case 4 -> turn.y();
      default -> turn.x();
    };
  }

  /** Returns a vector along the axes of the space at the start. */
  private Frame inStart(double x, double y, double z) {
    Frame vector = new Frame(x, y, z, 0, 0, 0);
    if (space == DriveSpace.BASE) {
      return vector;
    }
    Frame tool = start.position();
    return product(inverse(new Frame(0, 0, 0, tool.a(), tool.b(), tool.c())), vector);
  }
}
