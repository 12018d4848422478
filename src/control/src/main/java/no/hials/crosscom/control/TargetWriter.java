package no.hials.crosscom.control;

import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.structs.KRLAxis;
import no.hials.crosscom.KRL.structs.KRLFrame;
import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.kinematics.Frame;

/**
 * Writes one target that {@code krl/follow_axis.src} or {@code krl/follow_pos.src} goes to.
 *
 * <p><b>It moves a machine</b>, all the way at the speed that {@code JOV_SPEED} says. A target
 * passes the limits of {@link Safety} for where the axes and the tool may be, and the mode and the
 * program are checked before it is written. No heartbeat is sent; a motion that shall stop with the
 * client needs a {@link ControlLoop} or a {@link PathPlayer}.
 *
 * <p>For one thread at a time. It starts no thread.
 */
public final class TargetWriter {
  private final Channel channel;
  private final Safety safety;

  /**
   * Makes a writer.
   *
   * @param client the connection
   * @param safety the limits
   */
  public TargetWriter(CrossComClient client, Safety safety) {
    this.channel = new Channel(client);
    this.safety = safety;
  }

  /**
   * Sends the axes to angles.
   *
   * @param name the variable that the program follows, such as {@code JOV_AXIS}
   * @param axes the angles, degrees
   * @throws ControlRefusedException if a limit is broken, in which case nothing was written, or if
   *     an access failed
   */
  public void writeAxes(String name, Axes axes) throws ControlRefusedException {
    Preflight.check(channel, safety, false).check(axes, false);
    channel.write(new KRLAxis(name).setA1ToA6(axes.toArray()));
  }

  /**
   * Sends the tool to a position.
   *
   * @param name the variable that the program follows, such as {@code JOV_POS}
   * @param position the position in {@code $BASE}
   * @throws ControlRefusedException if a limit is broken, in which case nothing was written, or if
   *     an access failed
   */
  public void writePosition(String name, Frame position) throws ControlRefusedException {
    Preflight.check(channel, safety, true).check(position, false);
    channel.write(
        new KRLFrame(name)
            .setXToZ(position.x(), position.y(), position.z())
            .setAToC(position.a(), position.b(), position.c()));
  }
}
