package no.hials.crosscom.simulator.internal.core;

import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.Statement.MotionKind;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.program.KrlInterpreter;
import no.hials.crosscom.simulator.internal.program.MotionOrder;

/** Moves the robot without a program, as messages 11 and 12 of C3 Bridge ask for. */
final class ManualMotion {
  private enum State {
    NONE,
    MOTION,
    JOG
  }

  private final KrlInterpreter robot;
  private final AdvanceRun motions;
  private final OperatorPanel panel;
  private State state = State.NONE;

  ManualMotion(KrlInterpreter robot, AdvanceRun motions, OperatorPanel panel) {
    this.robot = robot;
    this.motions = motions;
    this.panel = panel;
  }

  boolean active() {
    return state != State.NONE;
  }

  boolean jogging() {
    return state == State.JOG;
  }

  void move(MotionKind kind, KrlStruct target) throws KrlExecutionException {
    requireReleased("move");
    if (jogging()) {
      throw new IllegalStateException("move: a jog key is pressed");
    }
    begin(State.MOTION, kind, target);
  }

  void jog(MotionKind kind, KrlStruct target) throws KrlExecutionException {
    requireReleased("jog");
    if (!panel.mode().manual()) {
      throw new IllegalStateException(
          "jog: the operating mode must be T1 or T2, is " + panel.mode());
    }
    end();
    begin(State.JOG, kind, target);
  }

  private void begin(State next, MotionKind kind, KrlStruct target) throws KrlExecutionException {
    motions.move(
        new MotionOrder(
            kind,
            null,
            target,
            OptionalDouble.empty(),
            Set.of(),
            null,
            "",
            "",
            new Position(kind.name(), 1, 1),
            List.of()));
    state = next;
  }

  private void requireReleased(String action) {
    ControllerCore.requireIdle(robot, action);
    panel.requireReleased(action);
    if (robot.state() == ProgramState.STOP && !active() && !motions.idle()) {
      throw new IllegalStateException(
          action + ": a program is stopped within a motion, reset or cancel it first");
    }
  }

  /** Slows the robot down and discards the motions, if it is moved manually. */
  void end() {
    if (active()) {
      motions.discardAll();
      state = State.NONE;
    }
  }

  /** Called after each cycle. */
  void cycle() {
    if (motions.finished()) {
      state = State.NONE;
    }
  }
}
