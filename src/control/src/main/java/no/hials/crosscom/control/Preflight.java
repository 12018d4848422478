package no.hials.crosscom.control;

/** What is looked at before anything is written that moves a robot. */
final class Preflight {
  private Preflight() {}

  /**
   * Checks the mode, the robot's program and where the robot is.
   *
   * @param cartesian whether the tool needs a workspace, be it around where it is
   * @return the limits from now on
   */
  static Guard check(Channel channel, Safety safety, boolean cartesian)
      throws ControlRefusedException {
    // two at a time, so that the client finds out now whether the server takes them together
    channel.read(channel.mode, channel.program);
    channel.checkMode(safety);
    channel.checkProgram();
    channel.read(channel.axes, channel.position);
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
