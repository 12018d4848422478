package no.hials.crosscom.simulator.internal.core;

import java.util.Optional;
import java.util.Set;
import no.hials.crosscom.kinematics.MachineDataException;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.simulator.internal.motion.Joints;

/**
 * The data of a robot in data lists (docs/reference/robots.md#machine-data).
 *
 * @param now the variables of {@link #SIGNS} that were just loaded
 * @param all those that were ever loaded
 */
public record RobotData(Set<String> now, Set<String> all) {
  /** The variable that tells the machine data of the robot from those of the controller. */
  private static final String TRAFONAME = "$TRAFONAME";

  /** The variable of {@code $config.dat} with the home position. */
  private static final String XHOME = "XHOME";

  /** The variable that is in the saved state of a controller. */
  private static final String AXIS_ACT = "$AXIS_ACT";

  /** The name that clients see, which not all machine data have. */
  private static final String MODEL_NAME = "$MODEL_NAME";

  /** The variables by which the data of a robot are recognised. */
  public static final Set<String> SIGNS = Set.of(TRAFONAME, XHOME, AXIS_ACT, MODEL_NAME);

  boolean isMachineData() {
    return now.contains(TRAFONAME);
  }

  boolean isHome() {
    return now.contains(XHOME);
  }

  /** Returns the robot of the machine data in the variables. */
  RobotModel robot(SystemVariableAccess access) throws MachineDataException {
    // the home position of the lists in the jar is that of another robot
    return RobotModel.fromMachineData(
        name -> name.equals(XHOME) && !all.contains(XHOME) ? Optional.empty() : access.value(name));
  }

  /** Sets the name of a robot whose machine data have only that of its transformation. */
  void name(SystemVariableAccess access) {
    if (!now.contains(MODEL_NAME)) {
      access.value(TRAFONAME + "[]").ifPresent(name -> access.write(MODEL_NAME + "[]", name));
    }
  }

  /**
   * Returns where a robot that has not moved stands, within the limits; empty to stay there, as
   * after the state of a controller was loaded.
   */
  Optional<Joints> home(SystemVariableAccess access, RobotModel robot) {
    if (all.contains(AXIS_ACT)) {
      return Optional.empty();
    }
    Joints read = access.joints(all.contains(XHOME) ? XHOME : "$AXIS_HOME[1]", robot.home());
    Joints home = isMachineData() ? new Joints(robot.home(), read.external()) : read;
    return robot.axesOutsideLimits(home.robot()).isEmpty() ? Optional.of(home) : Optional.empty();
  }
}
