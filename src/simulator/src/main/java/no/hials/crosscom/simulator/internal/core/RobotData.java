package no.hials.crosscom.simulator.internal.core;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import no.hials.crosscom.kinematics.MachineDataException;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.simulator.internal.data.SavedVariables;
import no.hials.crosscom.simulator.internal.motion.Joints;

/**
 * The data of a robot in data lists (docs/reference/robots.md#machine-data).
 *
 * @param now the variables of {@link #SIGNS} that were just loaded
 * @param all those that were ever loaded
 * @param before the variables of {@link #VARIABLES} as they were before lists changed them
 */
public record RobotData(Set<String> now, Set<String> all, SavedVariables before) {
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

  /** The variables that describe the robot, for all of which the data of one robot are used. */
  public static final Set<String> VARIABLES =
      Set.of(
          TRAFONAME,
          MODEL_NAME,
          XHOME,
          "$AXIS_HOME",
          "$H_POS",
          "$NUM_AX",
          "$MAIN_AXIS",
          "$WRIST_AXIS",
          "$DH_4",
          "$DH_5",
          "$TIRORO",
          "$LENGTH_A",
          "$LENGTH_B",
          "$TX3P3",
          "$TFLWP",
          "$AXIS_TYPE",
          "$AXIS_DIR",
          "$MAMES",
          "$SOFTN_END",
          "$SOFTP_END",
          "$VEL_AXIS_MA",
          "$RAT_MOT_AX",
          "$RAISE_TIME",
          "$VEL_MA",
          "$ACC_MA",
          "$VEL_CP_T1",
          "$VEL_CPT1_MA",
          "$ROBROOT",
          "$EX_AX_NUM",
          "$EX_KIN",
          "$ET1_AX",
          "$ET1_TA1KR",
          "$ET1_TFLA3",
          "$ERSYSROOT");

  /**
   * Data that are not used.
   *
   * @param variable the variable that is the reason, with an index or a component
   * @param reason the reason, with the robot that stays
   */
  public record UnusedData(String variable, String reason) {}

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

  /** Restores the data of the robot that stays; a home of another robot is that of no robot. */
  void restore(SystemVariableAccess access) {
    Set<String> names = new HashSet<>(VARIABLES);
    names.remove(XHOME);
    access.restore(before, names);
  }

  /** Restores the home of a robot outside whose limits a loaded one is; returns whether it is. */
  Optional<UnusedData> restoreHome(SystemVariableAccess access, RobotModel robot) {
    if (!all.contains(XHOME)
        || robot.axesOutsideLimits(access.position(XHOME, robot.home())).isEmpty()) {
      return Optional.empty();
    }
    access.restore(before, Set.of(XHOME));
    return Optional.of(
        new UnusedData(
            XHOME, "XHOME is not used: it is outside the limits of the " + robot.name()));
  }

  /**
   * Returns where a robot that has not moved stands, within the limits; empty to stay there, as
   * after the state of a controller was loaded.
   *
   * @param used whether the machine data, if there are any, are those of the robot
   */
  Optional<Joints> home(SystemVariableAccess access, RobotModel robot, boolean used) {
    if (all.contains(AXIS_ACT) || !(used || all.contains(XHOME))) {
      return Optional.empty();
    }
    Joints read = access.joints(all.contains(XHOME) ? XHOME : "$AXIS_HOME[1]", robot.home());
    Joints home = used && isMachineData() ? new Joints(robot.home(), read.external()) : read;
    return robot.axesOutsideLimits(home.robot()).isEmpty() ? Optional.of(home) : Optional.empty();
  }
}
