package no.hials.crosscom.simulator.internal.core;

import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import no.hials.crosscom.kinematics.UnreachableException;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.motion.Joints;
import no.hials.crosscom.simulator.internal.program.MessageWindow;
import no.hials.crosscom.simulator.internal.program.MotionOrder;
import no.hials.crosscom.simulator.internal.program.ProgramEnvironment;

/** The controller as the program of an interpreter uses it. */
final class InterpreterEnvironment implements ProgramEnvironment {
  /** Called when a statement has failed that does not stop the program. */
  @FunctionalInterface
  interface ErrorListener {
    void error(int number, Interpreter interpreter);
  }

  /** Called when a program has stopped in error. */
  @FunctionalInterface
  interface FaultListener {
    void failed(Interpreter interpreter, KrlExecutionException fault, Position position);
  }

  private static final int MAX_ADVANCE = 5;

  private final Interpreter interpreter;
  private final SystemVariableAccess access;
  private final LongSupplier time;
  private final Timers timers;
  private final AdvanceRun motions;
  private final Supplier<BlockCoincidence> coincidence;
  private final MessageWindow messages;
  private final ErrorListener errors;
  private final FaultListener listener;
  private final MotionSettings settings;

  InterpreterEnvironment(
      Interpreter interpreter,
      SystemVariableAccess access,
      LongSupplier time,
      Timers timers,
      AdvanceRun motions,
      Supplier<BlockCoincidence> coincidence,
      MessageWindow messages,
      ErrorListener errors,
      FaultListener listener) {
    this.interpreter = interpreter;
    this.access = access;
    this.time = time;
    this.timers = timers;
    this.motions = motions;
    this.coincidence = coincidence;
    this.messages = messages;
    this.errors = errors;
    this.listener = listener;
    this.settings = new MotionSettings(access);
  }

  @Override
  public long time() {
    return time.getAsLong();
  }

  @Override
  public int advance() {
    return coincidence.get().oneByOne()
        ? 0
        : (int) Math.max(0, Math.min(MAX_ADVANCE, access.number("$ADVANCE", 0)));
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
    motions.move(coincidence.get().planned(order));
  }

  @Override
  public Map<String, KrlValue> settings() {
    return settings.read();
  }

  @Override
  public void restore(Map<String, KrlValue> values) {
    settings.write(values);
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
    coincidence.get().lost();
  }

  @Override
  public void pulse(int output, boolean level, double seconds) throws KrlExecutionException {
    if (!(seconds > 0)) {
      throw new KrlExecutionException(
          KrlExecutionException.OUT_OF_RANGE, "a pulse takes more than 0 s, was given " + seconds);
    }
    if (!timers.pulse(output, level, timeAfter(seconds))) {
      throw new KrlExecutionException(
          KrlExecutionException.BAD_INDEX, "there is no $OUT[" + output + "]");
    }
  }

  @Override
  public Optional<KrlStruct> forward(KrlStruct axes) {
    Joints joints = near(axes);
    return Optional.of(
        PositionValues.e6Pos(
            motions.resolver().tcpInBase(joints),
            motions.model().status(joints.robot()),
            motions.model().turn(joints.robot()),
            joints.external()));
  }

  /** Returns an axis position; missing components are those of the robot. */
  private Joints near(KrlStruct axes) {
    Joints now = motions.interpolator().joints();
    return new Joints(
        PositionValues.toAxes(axes, now.robot()), PositionValues.toExternal(axes, now.external()));
  }

  @Override
  public Optional<KrlStruct> inverse(KrlStruct position, KrlStruct start) {
    try {
      Joints near = near(start);
      Axis external = PositionValues.toExternal(position, near.external());
      Axis axes = motions.resolver().inverse(position, near, external);
      return Optional.of(PositionValues.e6Axis(new Joints(axes, external)));
    } catch (UnreachableException e) {
      return Optional.empty();
    }
  }

  @Override
  public MessageWindow messages() {
    return messages;
  }

  @Override
  public void error(int number) {
    errors.error(number, interpreter);
  }

  @Override
  public void fault(KrlExecutionException fault, Position position) {
    listener.failed(interpreter, fault, position);
  }
}
