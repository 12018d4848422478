package no.hials.crosscom.simulator.internal.core;

import static no.hials.crosscom.kinematics.Frames.inverse;
import static no.hials.crosscom.kinematics.Frames.product;

import java.time.Duration;
import java.time.LocalDateTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.MotionTarget;
import no.hials.crosscom.simulator.internal.data.Scope;
import no.hials.crosscom.simulator.internal.motion.Joints;
import no.hials.crosscom.simulator.internal.program.KrlInterpreter;
import org.jspecify.annotations.Nullable;

/**
 * Shows the state of the simulation in the system variables (docs/reference/system-variables.md).
 * Numbers and texts are computed when they are read; variables that can be wired to an output are
 * written when they change.
 */
final class SystemVariables {
  /** The variables that stop the advance run (docs/reference/krl-language.md#advance-run). */
  private static final Set<String> STOP_ADVANCE =
      Set.of(
          "$IN",
          "$OUT",
          "$ANIN",
          "$ANOUT",
          "$TIMER",
          "$TIMER_STOP",
          "$TIMER_FLAG",
          "$POS_ACT",
          "$POS_ACT_MES",
          "$AXIS_ACT",
          "$AXIS_ACT_MEAS",
          "$VEL_ACT",
          "$VEL_AXIS_ACT",
          "$DIST_NEXT",
          "$POS_INT",
          "$AXIS_INT",
          "$POS_RET",
          "$AXIS_RET",
          "$POS_BACK",
          "$AXIS_BACK",
          "$POS_FOR",
          "$AXIS_FOR",
          "$BRAKE_SIG");

  /** The brakes of A1 to A6, open (docs/reference/system-variables.md#position-and-motion). */
  private static final int BRAKES_OPEN = 63;

  private static final double PERCENT = 100;
  private static final int SHOWN_LEVELS = 10;
  private static final int CENTISECOND_NANOS = 10_000_000;

  /**
   * The state after a cycle.
   *
   * @param axes the axes
   * @param axisVelocity degrees/s
   * @param externalVelocity % of the highest speeds
   * @param pathVelocity m/s
   * @param standing whether no axis moves
   * @param planned motions that have not started
   * @param distanceToEnd mm to the end of the motion
   * @param mode the operating mode
   * @param emergency whether the emergency stop is pressed
   * @param stopMessage whether a message has to be confirmed
   * @param idle whether all motions have ended
   * @param drives whether the signals of a higher-level controller leave the drives on
   * @param torques of the axes, Nm
   * @param currents %
   * @param temperatureRises K since the start
   * @param coincidenceDue whether the robot has not reached its programmed path
   * @param coincidenceRunning whether it is on its way there
   */
  @SuppressWarnings("ArrayRecordComponent") // neither compared nor changed
  record State(
      Joints axes,
      Axis axisVelocity,
      Axis externalVelocity,
      double pathVelocity,
      boolean standing,
      int planned,
      double distanceToEnd,
      OperatingMode mode,
      boolean emergency,
      boolean stopMessage,
      boolean idle,
      boolean drives,
      double[] torques,
      double[] currents,
      double[] temperatureRises,
      boolean coincidenceDue,
      boolean coincidenceRunning) {}

  /** The state of an interpreter. */
  private record Pointer(ProgramState state, String program, List<KrlInterpreter.Level> levels) {}

  private static final Pointer NO_POINTER = new Pointer(ProgramState.FREE, " ", List.of());

  private final Scope globals;
  private final SystemVariableAccess access;
  private final ExternalAxesData externalAxes;
  private volatile RobotModel robot;
  private final KrlInterpreter robotInterpreter;
  private final KrlInterpreter submitInterpreter;

  private volatile State state;
  private volatile Pointer robotPointer = NO_POINTER;
  private volatile Pointer submitPointer = NO_POINTER;

  /** The end and the start of the current motion, and the position at an interrupt. */
  private volatile Joints target;

  private volatile Joints origin;
  private volatile Joints interrupted;

  /** The position where an interrupt has put the motions aside. */
  private volatile Joints left;

  /** The base and the tool of the current motion; null between motions. */
  private volatile @Nullable Frame mainBase;

  private volatile @Nullable Frame mainTool;

  private boolean inInterrupt;

  SystemVariables(
      Scope globals,
      SystemVariableAccess access,
      RobotModel robot,
      KrlInterpreter robotInterpreter,
      KrlInterpreter submitInterpreter,
      State state) {
    this.globals = globals;
    this.access = access;
    this.externalAxes = new ExternalAxesData(access);
    this.robot = robot;
    this.robotInterpreter = robotInterpreter;
    this.submitInterpreter = submitInterpreter;
    this.state = state;
    target = state.axes();
    origin = state.axes();
    interrupted = state.axes();
    left = state.axes();
  }

  static boolean stopsAdvanceRun(String name) {
    return STOP_ADVANCE.contains(name.toUpperCase(Locale.ROOT));
  }

  // computed when they are read

  /**
   * Binds the computed variables.
   *
   * @param time ms since the start
   * @param begin the first value of $DATE
   */
  void bind(LongSupplier time, LocalDateTime begin) {
    long counted = (long) access.number("$ROB_TIMER", 0);
    bindPositions();
    bind("$VEL_ACT", () -> KrlReal.of(state.pathVelocity()));
    bind("$VEL_AXIS_ACT", this::axisVelocity);
    bind("$TORQUE_AXIS_ACT", () -> PositionValues.axisArray(state.torques()));
    bind("$CURR_ACT", () -> PositionValues.axisArray(state.currents()));
    bindTemperatures();
    bind("$DIST_NEXT", () -> KrlReal.of(-state.distanceToEnd()));
    bind("$ACT_ADVANCE", () -> new KrlInt(state.planned()));
    bind("$MOVE_BCO", () -> new KrlBool(state.coincidenceRunning()));
    // the brakes of a robot that waits for a program stay open (assumed)
    bind("$BRAKE_SIG", () -> new KrlInt(drivesOn() ? BRAKES_OPEN : 0));
    bind("$MODE_OP", () -> new KrlEnum(state.mode().constant()));
    bind("$ROB_TIMER", () -> new KrlInt((int) (counted + time.getAsLong())));
    bind("$DATE", () -> date(begin.plus(Duration.ofMillis(time.getAsLong()))));
    // the pendant shows the robot interpreter ($INTERPRETER 1)
    bindPointer("", () -> robotPointer);
    bindPointer("0", () -> submitPointer);
    bindPointer("1", () -> robotPointer);
  }

  /** The first temperatures are those of the data list. */
  private void bindTemperatures() {
    double[] first = new double[PositionValues.AXES];
    for (int i = 0; i < first.length; i++) {
      first[i] = access.number("$MOT_TEMP[" + (i + 1) + "]", 0);
    }
    bind(
        "$MOT_TEMP",
        () -> {
          List<KrlValue> kelvin = new ArrayList<>();
          double[] rises = state.temperatureRises();
          for (int i = 0; i < first.length; i++) {
            kelvin.add(new KrlInt((int) Math.round(first[i] + (i < rises.length ? rises[i] : 0))));
          }
          return new KrlArray(kelvin);
        });
  }

  private void bindPositions() {
    bind("$AXIS_ACT", () -> PositionValues.e6Axis(state.axes()));
    bind("$AXIS_ACT_MEAS", () -> PositionValues.e6Axis(state.axes()));
    bind("$AXIS_FOR", () -> PositionValues.e6Axis(target));
    bind("$AXIS_BACK", () -> PositionValues.e6Axis(origin));
    bind("$AXIS_INT", () -> PositionValues.e6Axis(interrupted));
    bind("$AXIS_RET", () -> PositionValues.e6Axis(left));
    bind("$POS_ACT", () -> position(state.axes()));
    bind("$POS_ACT_MES", () -> position(state.axes()));
    bind("$POS_FOR", () -> position(target));
    bind("$POS_BACK", () -> position(origin));
    bind("$POS_INT", () -> position(interrupted));
    bind("$BASE_C", () -> PositionValues.frame(baseOfMainRun()));
    bind("$ROBROOT_C", () -> PositionValues.frame(externalAxes.root(state.axes().external())));
    bind("$TOOL_C", () -> PositionValues.frame(toolOfMainRun()));
    bind("$POS_RET", () -> position(left));
  }

  private void bindPointer(String suffix, Supplier<Pointer> pointer) {
    bind("$PRO_STATE" + suffix, () -> new KrlEnum("P_" + pointer.get().state().name()));
    bind("$PRO_NAME" + suffix, () -> new KrlString(pointer.get().program()));
    bind("$PRO_IP" + suffix, () -> programPointer(pointer.get()));
  }

  /** Skips a variable that the user has removed or declared as a SIGNAL. */
  private void bind(String name, Supplier<KrlValue> value) {
    if (globals.contains(name)) {
      globals.bind(name, value);
    }
  }

  /**
   * In the base and with the tool of the main run
   * (docs/reference/system-variables.md#position-and-motion).
   */
  private KrlStruct position(Joints joints) {
    return position(joints, baseOfMainRun(), toolOfMainRun());
  }

  private KrlStruct position(Joints joints, Frame inBase, Frame withTool) {
    Axis axes = joints.robot();
    Frame baseInRoot = product(inverse(externalAxes.root(joints.external())), inBase);
    Frame tcp = product(inverse(baseInRoot), robot.forward(axes), withTool);
    return PositionValues.e6Pos(tcp, robot.status(axes), robot.turn(axes), joints.external());
  }

  /** Without a motion, the base of the advance run (assumed). */
  private Frame baseOfMainRun() {
    Frame of = mainBase;
    return of == null ? access.frame("$BASE") : of;
  }

  private Frame toolOfMainRun() {
    Frame of = mainTool;
    return of == null ? access.frame("$TOOL") : of;
  }

  /** In % of the highest speed. */
  private KrlValue axisVelocity() {
    double[] percent = new double[PositionValues.AXES];
    for (int i = 0; i < PositionValues.ROBOT_AXES; i++) {
      percent[i] = PERCENT * state.axisVelocity().get(i) / robot.maxSpeed(i);
      percent[i + PositionValues.ROBOT_AXES] = state.externalVelocity().get(i);
    }
    return PositionValues.axisArray(percent);
  }

  private boolean drivesOn() {
    return !state.emergency()
        && state.drives()
        && (!state.mode().manual() || robotPointer.state() == ProgramState.ACTIVE);
  }

  private static KrlStruct date(LocalDateTime date) {
    return struct(
        "DATE",
        integer("CSEC", date.getNano() / CENTISECOND_NANOS),
        integer("SEC", date.getSecond()),
        integer("MIN", date.getMinute()),
        integer("HOUR", date.getHour()),
        integer("DAY", date.getDayOfMonth()),
        integer("MONTH", date.getMonthValue()),
        integer("YEAR", date.getYear()));
  }

  private static KrlStruct struct(String type, KrlStruct.Field... fields) {
    return new KrlStruct(type, List.of(fields));
  }

  private static KrlStruct.Field integer(String name, int value) {
    return new KrlStruct.Field(name, new KrlInt(value));
  }

  private static KrlStruct.Field text(String name, String value) {
    return new KrlStruct.Field(name + "[]", new KrlString(value));
  }

  /** {@code /R1/XXX.SRC} (docs/reference/krl-values.md#fields-of-the-structures). */
  private static String moduleName(KrlInterpreter.Level level) {
    String file = level.position().file().toUpperCase(Locale.ROOT);
    String module = level.module().toUpperCase(Locale.ROOT);
    return "/R1/" + module + (file.endsWith(".SUB") ? ".SUB" : ".SRC");
  }

  /** The pointer of the main run is that of the advance run (assumed). */
  private static KrlStruct programPointer(Pointer pointer) {
    List<KrlInterpreter.Level> levels = pointer.levels();
    String name = levels.isEmpty() ? " " : moduleName(levels.get(0));
    int line = levels.isEmpty() ? 0 : levels.get(0).position().line();
    List<KrlStruct.Field> fields = new ArrayList<>();
    fields.add(text("NAME", name));
    fields.add(integer("SNR", line));
    fields.add(text("NAME_C", name));
    fields.add(integer("SNR_C", line));
    fields.add(new KrlStruct.Field("I_EXECUTED", new KrlBool(false)));
    fields.add(integer("P_ARRIVED", 0));
    for (int i = 0; i < Math.min(SHOWN_LEVELS, levels.size()); i++) {
      KrlInterpreter.Level level = levels.get(i);
      fields.add(
          new KrlStruct.Field(
              String.format(Locale.ROOT, "SI%02d", i + 1),
              struct(
                  "CALL_STACK",
                  text("NAME", moduleName(level)),
                  integer("SNR", level.position().line()),
                  new KrlStruct.Field("INT_FLAG", new KrlBool(level.interrupt())))));
    }
    return new KrlStruct("PRO_IP", fields);
  }

  // called by the core

  void robot(RobotModel another) {
    robot = another;
  }

  void current(Joints from, Joints to, Frame inBase, Frame withTool) {
    origin = from;
    target = to;
    mainBase = inBase;
    mainTool = withTool;
  }

  MotionTarget target(Joints to, Frame inBase, Frame withTool) {
    return new MotionTarget(position(to, inBase, withTool), PositionValues.e6Axis(to));
  }

  void leftPath(Joints axes) {
    left = axes;
  }

  /** Sets the number of an error in $ERR. */
  void error(int number, Interpreter kind) {
    boolean ofRobot = kind == Interpreter.ROBOT;
    List<KrlInterpreter.Level> levels = (ofRobot ? robotInterpreter : submitInterpreter).levels();
    int line = levels.isEmpty() ? 0 : levels.get(0).position().line();
    String module = levels.isEmpty() ? " " : moduleName(levels.get(0));
    String routine = levels.isEmpty() ? " " : levels.get(0).routine();
    access.write(
        "$ERR",
        new KrlStruct(
            null,
            List.of(
                integer("NUMBER", number),
                new KrlStruct.Field("INTERPRETER", new KrlEnum(ofRobot ? "R_INT" : "S_INT")),
                integer("LINE_NR", line),
                text("MODULE", module),
                text("UP_NAME", routine))));
  }

  void publish(State newState) {
    state = newState;
    if (newState.idle()) {
      mainBase = null;
      mainTool = null;
    }
    robotPointer = pointer(robotInterpreter, robotPointer);
    submitPointer = pointer(submitInterpreter, submitPointer);
    boolean interrupt =
        !robotPointer.levels().isEmpty() && robotPointer.levels().get(0).interrupt();
    if (interrupt && !inInterrupt) {
      interrupted = newState.axes();
    }
    inInterrupt = interrupt;
    boolean active = robotPointer.state() == ProgramState.ACTIVE;
    signal("$ROB_STOPPED", newState.standing());
    signal("$PRO_ACT", active);
    signal("$PRO_MOVE", !newState.idle() && active);
    signal("$ON_PATH", !newState.coincidenceDue());
    signal("$STOPMESS", newState.stopMessage());
    signal("$ALARM_STOP", !newState.emergency());
    signal("$PERI_RDY", drivesOn());
    signal("$IN_HOME", atHome(newState.axes().robot()));
    signal("$T1", newState.mode() == OperatingMode.T1);
    signal("$T2", newState.mode() == OperatingMode.T2);
    signal("$AUT", newState.mode() == OperatingMode.AUT);
    signal("$EXT", newState.mode() == OperatingMode.EXT);
  }

  private static Pointer pointer(KrlInterpreter interpreter, Pointer old) {
    List<KrlInterpreter.Level> levels = interpreter.levels();
    if (old.state() == interpreter.state() && old.levels().equals(levels)) {
      return old;
    }
    String program = interpreter.program().map(p -> p.name().toUpperCase(Locale.ROOT)).orElse(" ");
    return new Pointer(interpreter.state(), program, levels);
  }

  private void signal(String name, boolean value) {
    // compared each time: a data list or Java code may have changed the output
    if (access.bool(name, !value) != value) {
      access.write(name, new KrlBool(value));
    }
  }

  /** Within $H_POS_TOL of every axis of the home position. */
  private boolean atHome(Axis axes) {
    Axis tolerance = access.position("$H_POS_TOL", Axis.ZERO);
    Axis away = access.position("$H_POS", robot.home()).minus(axes);
    for (int i = 0; i < PositionValues.ROBOT_AXES; i++) {
      if (Math.abs(away.get(i)) > tolerance.get(i)) {
        return false;
      }
    }
    return true;
  }
}
