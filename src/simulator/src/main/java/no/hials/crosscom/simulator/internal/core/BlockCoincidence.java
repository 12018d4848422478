package no.hials.crosscom.simulator.internal.core;

import java.util.Set;
import no.hials.crosscom.lang.Statement.MotionKind;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.simulator.Message;
import no.hials.crosscom.simulator.internal.program.KrlInterpreter;
import no.hials.crosscom.simulator.internal.program.KrlInterpreter.LineStep;
import no.hials.crosscom.simulator.internal.program.MotionOrder;

/**
 * The BCO run of the robot's program, and its step modes
 * (docs/reference/krl-language.md#starting-a-program): decides when a started program stops at the
 * end of a motion.
 */
final class BlockCoincidence {
  /** The state message while a BCO run is due. */
  static final int DUE = 309;

  /** The message when the programmed path is reached. */
  static final int REACHED = 1350;

  private static final String DUE_TEXT = "a BCO run is due: the next motion is slow, then it stops";

  /** The value of {@code $PRO_MODE1}; the others run as {@code #GO} does. */
  private enum StepMode {
    GO,
    /** Stops after each motion. */
    MSTEP,
    /** Stops after each line. */
    ISTEP,
    /** Stops after each line, but not in the routines that it calls (assumed). */
    PSTEP,
    /** Stops after each motion that is not approximated (assumed). */
    CSTEP
  }

  private final KrlInterpreter robot;
  private final AdvanceRun motions;
  private final OperatorPanel panel;
  private final StepModeVariable variable;
  private boolean simulated = true;
  private boolean due;

  /** Whether the motion of the BCO run has been planned and has not ended. */
  private boolean running;

  /** Whether Start is pressed again at the end of the BCO run. */
  private boolean pressedAgain;

  private boolean dueShown;

  /** Whether a motion has been planned since Start. */
  private boolean moved;

  /** Whether the motion that was planned last is not approximated. */
  private boolean exact;

  BlockCoincidence(
      KrlInterpreter robot, AdvanceRun motions, OperatorPanel panel, StepModeVariable variable) {
    this.robot = robot;
    this.motions = motions;
    this.panel = panel;
    this.variable = variable;
  }

  /** Sets whether BCO runs are simulated. */
  void simulate(boolean value) {
    simulated = value;
    require(due && value);
  }

  /** Called when the program was selected, reset or set to another line. */
  void require() {
    require(simulated);
  }

  /** Called when the program was cancelled. */
  void forget() {
    require(false);
  }

  private void require(boolean value) {
    due = value;
    running = false;
    moved = false;
    pressedAgain = false;
  }

  /** Called when the program starts. */
  void started(boolean pressAgain) {
    pressedAgain = pressAgain;
    moved = false;
  }

  /** Returns the motion to plan: that of a BCO run ends exactly at its target. */
  MotionOrder planned(MotionOrder order) {
    moved = true;
    exact = order.approximations().isEmpty();
    if (!due || panel.mode() == OperatingMode.EXT) {
      due = false;
      return order;
    }
    running = true;
    // the start of a programmed circle is not known, so the robot goes straight to its end
    // (assumed)
    MotionKind kind =
        switch (order.kind()) {
          case CIRC -> MotionKind.LIN;
          case CIRC_REL -> MotionKind.LIN_REL;
          default -> order.kind();
        };
    return order.with(kind, Set.of());
  }

  /** Called when the planned motions were discarded; a BCO run is still due. */
  void lost() {
    running = false;
  }

  /** Returns whether the robot is on its way to the programmed path. */
  boolean running() {
    return running && panel.mode() != OperatingMode.EXT;
  }

  boolean due() {
    return due && panel.mode() != OperatingMode.EXT && robot.state() != ProgramState.FREE;
  }

  /** Returns whether no motion is planned before the last one has ended. */
  boolean oneByOne() {
    return running()
        || switch (mode()) {
          case GO -> false;
          case CSTEP -> exact;
          case MSTEP, ISTEP, PSTEP -> true;
        };
  }

  /** Returns at which lines the program stops. */
  LineStep lineStep() {
    return switch (mode()) {
      case ISTEP -> LineStep.INTO;
      case PSTEP -> LineStep.OVER;
      case GO, MSTEP, CSTEP -> LineStep.NONE;
    };
  }

  private StepMode mode() {
    return switch (variable.value()) {
      case "MSTEP" -> StepMode.MSTEP;
      case "ISTEP" -> StepMode.ISTEP;
      case "PSTEP" -> StepMode.PSTEP;
      case "CSTEP" -> StepMode.CSTEP;
      default -> StepMode.GO;
    };
  }

  /** Called before each cycle. */
  void prepare() {
    variable.cycle();
  }

  /** Called after each cycle: stops the program at the end of the BCO run, or of a step. */
  void cycle() {
    if (robot.state() == ProgramState.END) {
      due = false;
    }
    if (robot.state() == ProgramState.ACTIVE && motions.idle()) {
      if (running) {
        reached();
      } else if (moved && (mode() == StepMode.MSTEP || mode() == StepMode.CSTEP)) {
        boolean unused = robot.stop();
      }
    }
  }

  /** Shows in the messages whether a BCO run is due. */
  void show() {
    boolean shows = due() && !pressedAgain;
    if (shows != dueShown) {
      dueShown = shows;
      panel.state(dueShown, DUE, DUE_TEXT);
    }
  }

  private void reached() {
    boolean stops = running() && !pressedAgain;
    if (running()) {
      panel.show(Message.Kind.NOTIFICATION, REACHED, "programmed path reached (BCO)");
    }
    due = false;
    running = false;
    if (stops) {
      boolean unused = robot.stop();
    }
  }
}
