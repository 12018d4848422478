package no.hials.crosscom.simulator.internal.program;

import java.util.Locale;
import java.util.OptionalDouble;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.Statement;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.data.Operators;
import org.jspecify.annotations.Nullable;

/** Compiles motions and their triggers. */
final class MotionCompiler {
  private static final KrlInt ZERO = new KrlInt(0);

  /** The priority that lets the controller choose one for the subprogram of a trigger (assumed). */
  private static final KrlInt AUTOMATIC = new KrlInt(-1);

  private final CodeBuilder code;
  private final ExpressionCompiler expressions;

  MotionCompiler(CodeBuilder code, ExpressionCompiler expressions) {
    this.code = code;
    this.expressions = expressions;
  }

  /**
   * Compiles a trigger of the next motion.
   *
   * @param action its action
   */
  void trigger(Statement.Trigger trigger, CompiledCode action) {
    boolean calls = trigger.action() instanceof Statement.CallStatement;
    expressions.compile(trigger.distance());
    optional(trigger.position(), trigger.delay(), ZERO);
    optional(trigger.position(), trigger.priority(), AUTOMATIC);
    code.emit(
        trigger.position(),
        machine -> {
          // an assignment or a pulse ends at once, so it interrupts everything
          int priority = TriggerOrder.priority(calls, machine.popInt());
          double delay = machine.popNumber();
          double distance = machine.popNumber();
          Interruption interruption = new Interruption(priority, machine.frame(), action, true);
          machine.trigger(TriggerOrder.of(trigger.onPath(), distance, delay, interruption));
        });
  }

  private void optional(Position position, @Nullable Expression expression, KrlValue otherwise) {
    if (expression == null) {
      code.constant(position, otherwise);
    } else {
      expressions.compile(expression);
    }
  }

  /** Compiles a motion. The caller has compiled the stop of the advance run. */
  void motion(Statement.MotionStatement motion) {
    Position position = motion.position();
    // the target is evaluated when the motion can be planned (assumed)
    code.emit(position, KrlVirtualMachine::awaitAdvance);
    if (motion.auxiliary() != null) {
      expressions.compile(motion.auxiliary());
    }
    expressions.compile(motion.target());
    if (motion.circularAngle() != null) {
      expressions.compile(motion.circularAngle());
    }
    code.emit(position, machine -> machine.environment().move(order(machine, motion)));
    code.emit(position, KrlVirtualMachine::awaitMotionWithoutAdvance);
  }

  private static MotionOrder order(KrlVirtualMachine machine, Statement.MotionStatement motion)
      throws KrlExecutionException {
    OptionalDouble angle =
        motion.circularAngle() == null
            ? OptionalDouble.empty()
            : OptionalDouble.of(machine.popNumber());
    KrlStruct target = Operators.positionOf(machine.pop());
    KrlStruct auxiliary = motion.auxiliary() == null ? null : Operators.positionOf(machine.pop());
    String coordinates = motion.coordinates();
    return new MotionOrder(
        motion.kind(),
        auxiliary,
        target,
        angle,
        motion.approximations(),
        coordinates == null ? null : coordinates.replace("#", "").toUpperCase(Locale.ROOT),
        motion.target() instanceof Expression.Variable variable ? variable.name() : "",
        machine.module(),
        motion.position(),
        machine.takeTriggers());
  }
}
