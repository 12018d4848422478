package no.hials.crosscom.kinematics;

import no.hials.crosscom.protocol.value.Frame;

/**
 * Computes with frames.
 *
 * <p>The methods return A and C above -180 and up to 180 and B from -90 to 90; at B = ±90, where A
 * and C turn about the same axis, they return C = 0.
 */
public final class Frames {

  private Frames() {}

  /**
   * Transforms the last frame to the reference of the first one: KRL's geometric operator, {@code
   * first:second:last}.
   *
   * @param frames each in the coordinate system of the frame before it
   * @return the pose of the last frame in the reference of the first one
   */
  public static Frame product(Frame... frames) {
    Transform product = Transform.IDENTITY;
    for (Frame frame : frames) {
      product = product.times(Transform.of(frame));
    }
    return product.toFrame();
  }

  /**
   * Returns the inverse: the reference of a frame in its coordinate system.
   *
   * @param frame the frame
   * @return the frame whose product with it is {@link Frame#IDENTITY}, on either side
   */
  public static Frame inverse(Frame frame) {
    return Transform.of(frame).inverse().toFrame();
  }

  /**
   * Interpolates between two frames: the position on a straight line, the orientation about one
   * fixed axis in the shorter direction. For orientations 180 degrees apart the direction is
   * arbitrary but always the same.
   *
   * @param from the frame for {@code s = 0}
   * @param to the frame for {@code s = 1}
   * @param s 0 to 1
   */
  public static Frame interpolate(Frame from, Frame to, double s) {
    // The negation also refuses NaN.
    if (!(s >= 0 && s <= 1)) {
      throw new IllegalArgumentException("s must be 0 to 1, is " + s);
    }
    Transform start = Transform.of(from);
    Transform end = Transform.of(to);
    Rotation way = start.rotation().inverse().times(end.rotation());
    return new Transform(
            start.position().times(1 - s).plus(end.position().times(s)),
            start.rotation().times(way.part(s)))
        .toFrame();
  }

  /**
   * Returns the angle between the orientations of two frames.
   *
   * @param from a frame
   * @param to another frame with the same reference
   * @return the angle of the rotation from one orientation to the other, 0 to 180 degrees
   */
  public static double angle(Frame from, Frame to) {
    return Transform.of(from).rotation().inverse().times(Transform.of(to).rotation()).angle();
  }

  /**
   * Returns the rotation from one orientation to another, about one fixed axis in the shorter
   * direction.
   *
   * @param from a frame
   * @param to another frame with the same reference
   * @return the axis in the first frame, its length the angle, 0 to 180 degrees
   */
  public static double[] turn(Frame from, Frame to) {
    Rotation way = Transform.of(from).rotation().inverse().times(Transform.of(to).rotation());
    Vector axis = way.axis().times(way.angle());
    return new double[] {axis.x(), axis.y(), axis.z()};
  }

  /**
   * Turns a frame about an axis through its origin; {@code turned(from, turn(from, to))} has the
   * orientation of {@code to}.
   *
   * @param frame the frame
   * @param turn the axis in the frame, its length the angle in degrees
   */
  public static Frame turned(Frame frame, double[] turn) {
    Transform start = Transform.of(frame);
    Rotation rotation = Rotation.about(new Vector(turn[0], turn[1], turn[2]));
    return new Transform(start.position(), start.rotation().times(rotation)).toFrame();
  }
}
