package no.hials.crosscom.web.internal.programs;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.web.internal.robot.Readings.ReadOutcome;
import org.jspecify.annotations.Nullable;

/**
 * Finds out from variables why a robot does not move. The facts are from
 * docs/reference/system-variables.md#modes-and-programs and
 * docs/reference/krl-language.md#starting-a-program; advice without a source says "assumed".
 */
final class MoveChecks {
  /** The variables to read. Few controllers have the variables without {@code $}. */
  static final List<String> VARIABLES =
      List.of(
          "$MODE_OP",
          "$ALARM_STOP",
          "$USER_SAF",
          "$STOPMESS",
          "$ROB_CAL",
          "$PERI_RDY",
          "$SAFETY_SW",
          "$MOVE_ENABLE",
          "$DRIVES_OFF",
          "$PRO_STATE1",
          "$PRO_NAME1[]",
          "$PRO_MODE1",
          "$OV_PRO",
          "$ON_PATH",
          "$MOVE_BCO",
          "$WAIT_FOR[]",
          "$ROB_STOPPED",
          "$AXIS_ACT",
          "$POS_ACT",
          "$SOFTN_END[]",
          "$SOFTP_END[]",
          "JOV_TIMEOUT",
          "MYPOS",
          "MYAXIS",
          "JOV_POS",
          "JOV_AXIS",
          "JOV_COMMAND");

  /** A variable that no other view reads often: when it is read, all of them are. */
  static final String LAST_READ = "$ROB_CAL";

  private static final int AXES = 6;

  /** The distance in degrees within which an axis is at its limit. */
  private static final double AT_LIMIT = 0.05;

  private static final Set<String> MANUAL = Set.of("#T1", "#T2");

  private final ReadValues values;
  private final List<Check> checks = new ArrayList<>();
  private final String mode;
  private final String state;

  /** The result of a check. */
  enum State {
    OK,
    PROBLEM,
    /** It could not be read. */
    UNKNOWN
  }

  /**
   * A check.
   *
   * @param name what is checked
   * @param state its result
   * @param read the variables with their values, or why they could not be read
   * @param advice what to do, or what the result means; may be empty
   */
  record Check(String name, State state, String read, String advice) {}

  private MoveChecks(Map<String, ReadOutcome> values) {
    this.values = new ReadValues(values);
    mode = text("$MODE_OP");
    state = text("$PRO_STATE1");
  }

  /**
   * Returns the checks in the order of the causes: the first problem has to be solved first.
   *
   * @param values the results of reading {@link #VARIABLES}; a missing variable is unknown
   */
  static List<Check> of(Map<String, ReadOutcome> values) {
    MoveChecks all = new MoveChecks(values);
    all.run();
    return all.checks;
  }

  /** Returns whether the robot moves; null if that is unknown. */
  static @Nullable Boolean isMoving(Map<String, ReadOutcome> values) {
    return switch (new ReadValues(values).text("$ROB_STOPPED")) {
      case "TRUE" -> false;
      case "FALSE" -> true;
      default -> null;
    };
  }

  private void run() {
    checkServer();
    checkMode();
    expect(
        "Emergency stop",
        "$ALARM_STOP",
        "TRUE",
        "An emergency stop is pressed: on the pendant, or in the cell. Release it and confirm the"
            + " message. (That TRUE means no stop is assumed.)");
    checkOperatorSafety();
    expect(
        "Messages",
        "$STOPMESS",
        "FALSE",
        "A message stops the robot. Read it on the pendant, remove the cause, and confirm it.");
    expect(
        "Mastering",
        "$ROB_CAL",
        "TRUE",
        "An axis is not mastered: master it on the pendant before a program moves the robot.");
    checkOutside();
    checkProgram();
    checkOverride();
    checkLimits();
    if (isManual()) { // the drives are on while the enabling switch is held
      checkStart();
      checkDrives();
    } else {
      checkDrives();
      checkStart();
    }
    checkSteps();
    checkWait();
    checkWatchdog();
    FollowedVariable.check(values).ifPresent(checks::add);
    checkMotion();
  }

  private String text(String name) {
    return values.text(name);
  }

  private String read(String... names) {
    return values.print(names);
  }

  private boolean isManual() {
    return MANUAL.contains(mode);
  }

  private boolean isActive() {
    return state.equals("#P_ACTIVE");
  }

  private void add(String name, State result, String read, String advice) {
    checks.add(new Check(name, result, read, advice));
  }

  /** Adds a check of a variable that should have one value. */
  private void expect(String name, String variable, String good, String advice) {
    String actual = text(variable);
    State result =
        actual.equals(good)
            ? State.OK
            : actual.isEmpty() || values.get(variable) instanceof KrlBool != isBool(good)
                ? State.UNKNOWN
                : State.PROBLEM;
    add(name, result, read(variable), result == State.PROBLEM ? advice : "");
  }

  private static boolean isBool(String text) {
    return text.equals("TRUE") || text.equals("FALSE");
  }

  // the checks

  private void checkServer() {
    if (values.lost() != null) {
      add(
          "Server",
          State.PROBLEM,
          values.lost(),
          "Nothing below is up to date. Is the controller on, does its server run, and is the"
              + " network connected?");
    } else if (values.isEmpty()) {
      add("Server", State.UNKNOWN, "nothing read yet", "");
    } else {
      add("Server", State.OK, "it answers", "");
    }
  }

  private void checkMode() {
    String needs =
        switch (mode) {
          case "#T1" -> "Slow. A person holds the enabling switch and the start key.";
          case "#T2" ->
              "As fast as the program. A person holds the enabling switch and the start key.";
          case "#AUT" -> "Needs drives that are on, and Start. Nobody holds an enabling switch.";
          case "#EX" ->
              "The PLC switches the drives on and starts the program ($DRIVES_ON, $EXT_START).";
          default -> "Turn the mode selector to a mode.";
        };
    State result =
        mode.isEmpty() ? State.UNKNOWN : mode.equals("#INVALID") ? State.PROBLEM : State.OK;
    add("Operating mode", result, read("$MODE_OP"), mode.isEmpty() ? "" : needs);
  }

  private void checkOperatorSafety() {
    if (isManual() && text("$USER_SAF").equals("FALSE")) {
      add(
          "Operator safety",
          State.OK,
          read("$USER_SAF"),
          "The gate is open, which T1 and T2 permit (assumed).");
    } else {
      expect(
          "Operator safety",
          "$USER_SAF",
          "TRUE",
          "Close the gate and acknowledge it, so that AUT and EXT are permitted (assumed).");
    }
  }

  private void checkOutside() {
    if (mode.equals("#EX")) {
      expect("Motion released by the PLC", "$MOVE_ENABLE", "TRUE", "The PLC has to set it.");
      expect("Drives released by the PLC", "$DRIVES_OFF", "TRUE", "The PLC has to set it.");
    }
  }

  private void checkProgram() {
    boolean none = state.equals("#P_FREE");
    add(
        "Program",
        state.isEmpty() ? State.UNKNOWN : none ? State.PROBLEM : State.OK,
        read("$PRO_NAME1[]", "$PRO_STATE1"),
        none
            ? "No program is selected. Select one on the pendant, or on this page with C3 Bridge."
            : "");
  }

  private void checkOverride() {
    String override = text("$OV_PRO");
    boolean zero = override.equals("0");
    add(
        "Override",
        override.isEmpty() ? State.UNKNOWN : zero ? State.PROBLEM : State.OK,
        read("$OV_PRO"),
        zero ? "Raise the program override: at 0 % nothing moves." : "");
  }

  private void checkLimits() {
    String name = "Software limits";
    if (!(values.get("$AXIS_ACT") instanceof KrlStruct axes)
        || !(values.get("$SOFTN_END[]") instanceof KrlArray lower)
        || !(values.get("$SOFTP_END[]") instanceof KrlArray upper)
        || lower.elements().size() < AXES
        || upper.elements().size() < AXES) {
      add(name, State.UNKNOWN, "$AXIS_ACT, $SOFTN_END[] or $SOFTP_END[] could not be read", "");
      return;
    }
    List<String> reached = new ArrayList<>();
    for (int i = 0; i < AXES; i++) {
      double low = ReadValues.number(lower.elements().get(i));
      double high = ReadValues.number(upper.elements().get(i));
      double axis = axes.get("A" + (i + 1)).map(ReadValues::number).orElse(Double.NaN);
      if (Double.isNaN(axis + low + high)) {
        add(name, State.UNKNOWN, "A" + (i + 1) + " or its limits are not numbers", "");
        return;
      }
      if (axis <= low + AT_LIMIT || axis >= high - AT_LIMIT) {
        reached.add(
            String.format(Locale.ROOT, "A%d is at %.2f of %.2f to %.2f", i + 1, axis, low, high));
      }
    }
    if (reached.isEmpty()) {
      add(name, State.OK, "A1 to A6 are inside", "");
    } else {
      add(
          name,
          State.PROBLEM,
          String.join(", ", reached),
          "The axis is at its limit: it only moves back. Jog it away in T1.");
    }
  }

  private void checkStart() {
    boolean standing = List.of("#P_RESET", "#P_STOP", "#P_END").contains(state);
    if (standing && mode.equals("#EX")) {
      add(
          "Start",
          State.PROBLEM,
          read("$PRO_STATE1", "$ON_PATH"),
          "The program stands. In EXT the PLC starts it ($EXT_START).");
      return;
    }
    String advice =
        switch (state) {
          case "#P_RESET" ->
              "Press Start. The first motion is the slow BCO run to the program's first point; at"
                  + " its end the robot stops: press Start again.";
          case "#P_STOP" -> stopAdvice();
          case "#P_END" -> "The program has ended. Press Start to run it from its beginning.";
          case "#P_FREE" -> "Select a program first.";
          case "#P_ACTIVE" ->
              text("$MOVE_BCO").equals("TRUE")
                  ? "The slow BCO run goes on. The robot stops at its end: press Start again."
                  : "";
          default -> "";
        };
    add(
        "Start",
        isActive()
            ? State.OK
            : state.isEmpty() || state.equals("#P_FREE") ? State.UNKNOWN : State.PROBLEM,
        read("$PRO_STATE1", "$ON_PATH"),
        advice);
  }

  private String stopAdvice() {
    if (text("$STOPMESS").equals("TRUE")) {
      return "The program was stopped by a message. Confirm it, and press Start.";
    }
    return text("$ON_PATH").equals("FALSE")
        ? "Press Start: the robot returns to its path by a slow BCO run and stops; press Start"
            + " again."
        : "The program was stopped, has reached a HALT, or is at the end of its BCO run. Press"
            + " Start.";
  }

  private void checkDrives() {
    boolean off = text("$PERI_RDY").equals("FALSE");
    String advice =
        isManual()
            ? "The drives are off: nobody holds the enabling switch of the pendant ($SAFETY_SW = "
                + (text("$SAFETY_SW").isEmpty() ? "unknown" : text("$SAFETY_SW"))
                + "). Hold it, and start."
            : mode.equals("#EX")
                ? "The drives are off: the PLC switches them on by $DRIVES_ON."
                : "The drives are off: switch them on at the pendant.";
    add(
        isManual() ? "Enabling switch and drives" : "Drives",
        off ? State.PROBLEM : text("$PERI_RDY").equals("TRUE") ? State.OK : State.UNKNOWN,
        read("$PERI_RDY"),
        off ? advice : "");
  }

  private void checkSteps() {
    expect(
        "Step mode",
        "$PRO_MODE1",
        "#GO",
        "The program stops after each step, and each one needs Start. Set $PRO_MODE1 to #GO to run"
            + " through.");
  }

  private void checkWait() {
    String waits = text("$WAIT_FOR[]");
    boolean known = values.get("$WAIT_FOR[]") != null;
    boolean problem = isActive() && !waits.isEmpty();
    add(
        "WAIT FOR",
        !known ? State.UNKNOWN : problem ? State.PROBLEM : State.OK,
        read("$WAIT_FOR[]"),
        problem ? "The program waits until this is true: look at the input or variable." : "");
  }

  private void checkWatchdog() {
    if (values.get("JOV_TIMEOUT") != null) { // few controllers have it
      expect(
          "Watchdog of the client",
          "JOV_TIMEOUT",
          "FALSE",
          "No client sends the heartbeat within JOV_LIMIT ms: start the client, or write 0 to"
              + " JOV_LIMIT. Then press Start.");
    }
  }

  private void checkMotion() {
    String stopped = text("$ROB_STOPPED");
    boolean stands = stopped.equals("TRUE");
    add(
        "Motion",
        stopped.equals("FALSE") ? State.OK : State.UNKNOWN,
        read("$ROB_STOPPED"),
        !stands
            ? ""
            : isActive()
                ? "The program runs and the robot stands: it computes or waits (look at the running"
                    + " line), or the target is where the robot is."
                : "The robot stands.");
  }
}
