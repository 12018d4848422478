package no.hials.crosscom.simulator.internal.core;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import no.hials.crosscom.kinematics.MachineDataException;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.simulator.Message;
import no.hials.crosscom.simulator.internal.motion.Joints;

/** Replaces the robot when machine data are loaded, and puts it at its first position. */
final class RobotChanger {
  private static final String ACTIVE = "a program is active";

  private final SystemVariableAccess access;
  private final AdvanceRun motions;
  private final SystemVariables variables;
  private final OperatorPanel panel;

  /** Whether the last machine data describe another robot than the one that is simulated. */
  private boolean another;

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

  /** Uses loaded data; if they cannot be used, a message says why. Returns the reasons. */
  List<RobotData.UnusedData> loaded(RobotData data, boolean active) {
    List<RobotData.UnusedData> refusals = new ArrayList<>();
    boolean idle = !active && motions.idle();
    boolean moved = !motions.interpolator().joints().equals(start);
    if (data.isMachineData()) {
      Optional<RobotData.UnusedData> refusal = replace(data, idle);
      another = refusal.isPresent();
      refusal.ifPresent(refusals::add);
    } else if (!idle) {
      refusals.add(notUsed("XHOME", ACTIVE));
    }
    if (another) {
      data.restoreHome(access, motions.model()).ifPresent(refusals::add);
    }
    if (idle) {
      motions.readLimits();
      Optional<Joints> home = data.home(access, motions.model(), !another);
      if (!moved && home.isPresent()) {
        start = home.get();
        motions.place(start);
      }
    }
    refusals.forEach(
        refusal ->
            panel.show(Message.Kind.NOTIFICATION, OperatorPanel.OTHER_ROBOT, refusal.reason()));
    return refusals;
  }

  /** Replaces the robot, or restores the data of the present one. */
  private Optional<RobotData.UnusedData> replace(RobotData data, boolean idle) {
    try {
      if (!idle) {
        data.restore(access);
        return Optional.of(notUsed("$TRAFONAME", ACTIVE));
      }
      RobotModel robot = data.robot(access);
      motions.robot(robot);
      variables.robot(robot);
      data.name(access);
      data.before().forget();
      return Optional.empty();
    } catch (MachineDataException e) {
      data.restore(access);
      return Optional.of(notUsed(e.variable(), String.valueOf(e.getMessage())));
    }
  }

  private RobotData.UnusedData notUsed(String variable, String reason) {
    return new RobotData.UnusedData(
        variable,
        "the robot stays a " + motions.model().name() + ", its new data are not used: " + reason);
  }
}
