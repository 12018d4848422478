package no.hials.crosscom.control;

import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.structs.KRLAxis;
import no.hials.crosscom.KRL.structs.KRLFrame;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;

/**
 * Writes a single target for {@code krl/follow_axis.src} or {@code krl/follow_pos.src}.
 *
 * <p><b>It moves a machine</b> to the target at the speed in {@code JOV_SPEED}. The target is
 * checked against the limits of {@link Safety} for the axes and the tool, and the mode and the
 * program are checked before it is written. No heartbeat is sent; for a motion that stops with the
 * client use a {@link ControlLoop} or a {@link PathPlayer}.
 *
 * <p>Not thread-safe. It starts no thread.
 */
public final class TargetWriter {
  private final Channel channel;
  private final Safety safety;

  /**
   * Creates a writer.
   *
   * @param client the connection
   * @param safety the limits
   */
  public TargetWriter(CrossComClient client, Safety safety) {
    this.channel = new Channel(client);
    this.safety = safety;
  }

  /**
   * Moves the axes to positions.
   *
   * @param name the variable that the program follows, such as {@code JOV_AXIS}
   * @param axes the angles, degrees
   * @throws ControlRefusedException if a limit is violated, in which case nothing was written, or
   *     if an access failed
   */
  public void writeAxes(String name, Axis axes) throws ControlRefusedException {
    Preflight.check(channel, safety, false).check(axes, false);
    KRLAxis target = new KRLAxis(name);
    target.setValue(axes);
    channel.write(target);
  }

  /**
   * Moves the tool to a position.
   *
   * @param name the variable that the program follows, such as {@code JOV_POS}
   * @param position the position in {@code $BASE}
   * @throws ControlRefusedException if a limit is violated, in which case nothing was written, or
   *     if an access failed
   */
  public void writePosition(String name, Frame position) throws ControlRefusedException {
    Preflight.check(channel, safety, true).check(position, false);
    KRLFrame target = new KRLFrame(name);
    target.setValue(position);
    channel.write(target);
  }
}
