package no.hials.crosscom.simulator.internal.core;

import java.util.function.LongSupplier;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.data.VariablePath;
import no.hials.crosscom.simulator.internal.program.MotionOrder;

/** The requests of the robot interpreter, which moves the robot. */
final class RobotEnvironment extends InterpreterEnvironment {
  private static final VariablePath ADVANCE = SystemVariableAccess.path("$ADVANCE");
  private static final int MAX_ADVANCE = 5;

  private final SystemVariableAccess access;
  private final AdvanceRun motions;

  RobotEnvironment(
      SystemVariableAccess access,
      LongSupplier time,
      Timers timers,
      AdvanceRun motions,
      FaultListener listener) {
    super(Interpreter.ROBOT, time, timers, motions, listener);
    this.access = access;
    this.motions = motions;
  }

  @Override
  public int advance() {
    return (int) Math.max(0, Math.min(MAX_ADVANCE, access.number(ADVANCE, 0)));
  }

  @Override
  public int motionsAhead() {
    return motions.ahead();
  }

  @Override
  public boolean motionFinished() {
    return motions.finished();
  }

  @Override
  public void move(MotionOrder order) throws KrlExecutionException {
    motions.move(order);
  }

  @Override
  public void holdMotion(boolean maximum) {
    motions.hold(maximum);
  }

  @Override
  public void releaseMotion() {
    motions.release();
  }

  @Override
  public void discardMotion(int holds) {
    motions.discard(holds);
  }
}
