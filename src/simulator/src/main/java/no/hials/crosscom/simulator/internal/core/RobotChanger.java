package no.hials.crosscom.simulator.internal.core;

import java.util.Optional;
import no.hials.crosscom.kinematics.MachineDataException;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.simulator.Message;
import no.hials.crosscom.simulator.internal.motion.Joints;

/** Replaces the robot when machine data are loaded, and puts it at its first position. */
final class RobotChanger {
  private final SystemVariableAccess access;
  private final AdvanceRun motions;
  private final SystemVariables variables;
  private final OperatorPanel panel;

  /** Where the robot stands until it moves for the first time. */
  private Joints start;

  RobotChanger(
      SystemVariableAccess access,
      AdvanceRun motions,
      SystemVariables variables,
      OperatorPanel panel) {
    this.access = access;
    this.motions = motions;
    this.variables = variables;
    this.panel = panel;
    start = motions.interpolator().joints();
  }

  /** Uses loaded data; if they cannot be used, a message says why. */
  void loaded(RobotData data, boolean active) {
    if (active || !motions.idle()) {
      refuse("a program is active");
      return;
    }
    boolean moved = !motions.interpolator().joints().equals(start);
    try {
      if (data.isMachineData()) {
        RobotModel robot = data.robot(access);
        motions.robot(robot);
        variables.robot(robot);
        data.name(access);
      }
    } catch (MachineDataException e) {
      refuse(String.valueOf(e.getMessage()));
      return;
    }
    motions.readLimits();
    Optional<Joints> home = data.home(access, motions.model());
    if (!moved && home.isPresent()) {
      start = home.get();
      motions.place(start);
    }
  }

  private void refuse(String reason) {
    panel.show(
        Message.Kind.NOTIFICATION,
        OperatorPanel.OTHER_ROBOT,
        "the robot stays a " + motions.model().name() + ", its new data are not used: " + reason);
  }
}
