package no.hials.crosscom.control;

import java.util.List;

/** The checks before the first motion. */
final class Preflight {
  private Preflight() {}

  /**
   * Checks the mode, the robot program and the position of the robot.
   *
   * @param cartesian whether the tool needs a workspace, by default around its position
   * @return the limits to apply from now on
   */
  static Guard check(Channel channel, Safety safety, boolean cartesian)
      throws ControlRefusedException {
    // two at a time, so that the client detects now whether the server supports it
    channel.read(List.of(channel.mode, channel.program));
    channel.checkMode(safety);
    channel.checkProgram();
    channel.read(List.of(channel.axes, channel.position));
    AxisLimits axisLimits = safety.axisLimits();
    Workspace workspace = safety.workspace();
    if (workspace == null && cartesian) {
      workspace = Workspace.around(channel.frame(), Safety.REACH);
    }
    Guard guard =
        new Guard(safety, axisLimits == null ? channel.readAxisLimits() : axisLimits, workspace);
    guard.check(channel.joints(), false);
    guard.check(channel.frame(), false);
    return guard;
  }
}
