package no.hials.crosscom.simulator.internal.core;

import java.util.function.LongSupplier;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.program.MotionOrder;

/** The requests of the submit interpreter, which cannot move the robot. */
final class SubmitEnvironment extends InterpreterEnvironment {
  SubmitEnvironment(LongSupplier time, Timers timers, AdvanceRun motions, FaultListener listener) {
    super(Interpreter.SUBMIT, time, timers, motions, listener);
  }

  @Override
  public int advance() {
    return 0;
  }

  @Override
  public int motionsAhead() {
    return 0;
  }

  @Override
  public boolean motionFinished() {
    return true;
  }

  @Override
  public void move(MotionOrder order) throws KrlExecutionException {
    throw new KrlExecutionException(
        KrlExecutionException.NOT_ALLOWED, "the submit interpreter cannot move the robot");
  }

  @Override
  public void holdMotion(boolean maximum) {}

  @Override
  public void releaseMotion() {}

  @Override
  public void discardMotion(int holds) {}
}
