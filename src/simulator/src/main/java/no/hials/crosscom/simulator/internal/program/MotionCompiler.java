package no.hials.crosscom.simulator.internal.program;

import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.Set;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.Statement;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.data.Operators;
import no.hials.crosscom.simulator.internal.motion.PathPoint;
import org.jspecify.annotations.Nullable;

/** Compiles motions and their triggers. */
final class MotionCompiler {
  private static final KrlInt ZERO = new KrlInt(0);

  /** The priority that lets the controller choose one for the subprogram of a trigger (assumed). */
  private static final KrlInt AUTOMATIC = new KrlInt(-1);

  /** The number of KSS for a trigger of the old kind in a spline block. */
  private static final int NO_DISTANCE = 2363;

  private static final TypeSwitch<MotionCompiler, Statement.SplineElement, Void, RuntimeException>
      ELEMENTS =
          TypeSwitch.create(
              Statement.SplineElement.class,
              cases ->
                  cases
                      .run(Statement.SplineMotion.class, MotionCompiler::segment)
                      .run(Statement.Trigger.class, (c, it) -> c.trigger(it, true))
                      .run(Statement.TimeBlock.class, MotionCompiler::time)
                      .run(Statement.ConstantVelocity.class, MotionCompiler::constantVelocity)
                      .run(Statement.StopOnPath.class, (c, it) -> c.stop(it, true)));

  /** The compiler of the statements around a motion. */
  interface Statements {
    /** Compiles an assignment without the stop of the advance run. */
    void assign(Statement.AssignmentStatement assignment);

    /** Compiles the action of a trigger. */
    CompiledCode detached(Statement.Action action);

    /** Compiles a condition that is evaluated later. */
    CompiledCode condition(Expression condition);
  }

  private final CodeBuilder code;
  private final ExpressionCompiler expressions;
  private final Statements statements;

  MotionCompiler(CodeBuilder code, ExpressionCompiler expressions, Statements statements) {
    this.code = code;
    this.expressions = expressions;
    this.statements = statements;
  }

  /** Compiles a trigger of the next motion. */
  void trigger(Statement.Trigger trigger) {
    trigger(trigger, false);
  }

  private void trigger(Statement.Trigger trigger, boolean inBlock) {
    if (inBlock && !trigger.onPath()) {
      code.emit(
          trigger.position(),
          machine -> {
            throw new KrlExecutionException(
                NO_DISTANCE, "TRIGGER WHEN DISTANCE is not allowed in a spline block");
          });
    }
    CompiledCode action = statements.detached(trigger.action());
    boolean calls = trigger.action() instanceof Statement.CallStatement;
    expressions.compile(trigger.distance());
    expressions.compileOr(trigger.position(), trigger.delay(), ZERO);
    expressions.compileOr(trigger.position(), trigger.priority(), AUTOMATIC);
    code.emit(
        trigger.position(),
        machine -> {
          // an assignment or a pulse ends at once, so it interrupts everything
          int priority = TriggerOrder.priority(calls, machine.popInt());
          double delay = machine.popNumber();
          double distance = machine.popNumber();
          Interruption interruption = new Interruption(priority, machine.frame(), action, true);
          int point = point(machine, trigger.onStart(), inBlock);
          machine.trigger(TriggerOrder.of(trigger.onPath(), distance, delay, interruption, point));
        });
  }

  private static int point(KrlVirtualMachine machine, boolean onStart, boolean inBlock) {
    if (inBlock) {
      return machine.next().spline().at(onStart, 0).point();
    }
    return onStart ? 0 : PathPoint.LAST;
  }

  /** Compiles a stop on the path of the next motion. */
  void stop(Statement.StopOnPath stop) {
    stop(stop, false);
  }

  private void stop(Statement.StopOnPath stop, boolean inBlock) {
    CompiledCode condition = statements.condition(stop.condition());
    expressions.compile(stop.distance());
    code.emit(
        stop.position(),
        machine -> {
          double mm = machine.popNumber();
          PathPoint at = new PathPoint(point(machine, stop.onStart(), inBlock), mm);
          machine.stop(new MotionOrder.Stop(at, condition, machine.frame()));
        });
  }

  private void time(Statement.TimeBlock time) {
    expressions.compileOr(time.position(), time.value(), ZERO);
    code.emit(
        time.position(), machine -> machine.next().spline().add(time.part(), machine.popNumber()));
  }

  private void constantVelocity(Statement.ConstantVelocity line) {
    expressions.compile(line.distance());
    code.emit(
        line.position(),
        machine -> {
          PathPoint at = machine.next().spline().at(line.onStart(), machine.popNumber());
          machine.next().spline().addConstantVelocity(line.end(), at);
        });
  }

  /** Compiles a single spline motion. The caller has compiled the stop of the advance run. */
  void spline(Statement.SplineMotion motion) {
    Position position = motion.position();
    code.emit(position, KrlVirtualMachine::awaitAdvance);
    code.emit(position, MotionCompiler::beginSpline);
    values(motion);
    code.emit(
        position,
        machine -> {
          MotionOrder order =
              order(machine, motion, machine.next().takeTriggers(), machine.next().takeStops());
          machine.next().endSpline();
          machine.environment().move(order);
        });
    code.emit(position, KrlVirtualMachine::awaitMotionWithoutAdvance);
  }

  private static void beginSpline(KrlVirtualMachine machine) {
    machine.next().beginSpline(machine.environment());
  }

  private void segment(Statement.SplineMotion segment) {
    values(segment);
    code.emit(
        segment.position(),
        machine -> machine.next().spline().add(order(machine, segment, List.of(), List.of())));
  }

  /** Compiles the settings and points of a spline motion. */
  private void values(Statement.SplineMotion motion) {
    motion.with().forEach(statements::assign);
    points(motion.auxiliary(), motion.target(), motion.circularAngle());
  }

  /** Compiles a block. The caller has compiled the stop of the advance run. */
  void block(Statement.SplineBlock block) {
    Position position = block.position();
    code.emit(position, KrlVirtualMachine::awaitAdvance);
    code.emit(position, MotionCompiler::beginSpline);
    block.with().forEach(statements::assign);
    code.emit(position, machine -> machine.next().spline().beginSegments());
    block.elements().forEach(element -> ELEMENTS.run(this, element));
    code.emit(position, machine -> moveAlong(machine, block));
    code.emit(position, KrlVirtualMachine::awaitMotionWithoutAdvance);
  }

  private static void moveAlong(KrlVirtualMachine machine, Statement.SplineBlock block)
      throws KrlExecutionException {
    SplineBuilder spline = machine.next().spline();
    List<TriggerOrder> triggers = machine.next().takeTriggers();
    List<MotionOrder.Stop> stops = machine.next().takeStops();
    if (spline.segments().isEmpty()) {
      throw new KrlExecutionException(
          KrlExecutionException.NOT_ALLOWED, "a spline block needs a segment");
    }
    MotionOrder last = spline.segments().get(spline.segments().size() - 1);
    MotionOrder order =
        new MotionOrder(
            last.kind(),
            null,
            last.target(),
            OptionalDouble.empty(),
            approximation(block.approximate()),
            last.coordinates(),
            last.pointName(),
            last.module(),
            block.position(),
            triggers,
            stops,
            MotionOrder.Form.SPLINE,
            spline.settings(),
            spline.block(block.pointToPoint()));
    machine.next().endSpline();
    machine.environment().move(order);
  }

  /** The points of a motion, whose values are on the stack. */
  private record Points(
      @Nullable KrlStruct auxiliary, KrlStruct target, OptionalDouble circularAngle) {
    static Points pop(
        KrlVirtualMachine machine,
        @Nullable Expression auxiliary,
        @Nullable Expression circularAngle)
        throws KrlExecutionException {
      OptionalDouble angle =
          circularAngle == null ? OptionalDouble.empty() : OptionalDouble.of(machine.popNumber());
      KrlStruct target = Operators.positionOf(machine.pop());
      return new Points(
          auxiliary == null ? null : Operators.positionOf(machine.pop()), target, angle);
    }
  }

  /** Compiles what {@link Points#pop} takes from the stack. */
  private void points(
      @Nullable Expression auxiliary, Expression target, @Nullable Expression circularAngle) {
    if (auxiliary != null) {
      expressions.compile(auxiliary);
    }
    expressions.compile(target);
    if (circularAngle != null) {
      expressions.compile(circularAngle);
    }
  }

  private static Set<Statement.Approximation> approximation(boolean approximate) {
    return approximate ? Set.of(Statement.Approximation.C_DIS) : Set.of();
  }

  private static MotionOrder order(
      KrlVirtualMachine machine,
      Statement.SplineMotion motion,
      List<TriggerOrder> triggers,
      List<MotionOrder.Stop> stops)
      throws KrlExecutionException {
    Points points = Points.pop(machine, motion.auxiliary(), motion.circularAngle());
    boolean through =
        motion.kind() == Statement.SplineKind.SPL || motion.kind() == Statement.SplineKind.SPL_REL;
    return new MotionOrder(
        kind(motion.kind()),
        points.auxiliary(),
        points.target(),
        points.circularAngle(),
        approximation(motion.approximate()),
        constant(motion.coordinates()),
        pointName(motion.target()),
        machine.module(),
        motion.position(),
        triggers,
        stops,
        through ? MotionOrder.Form.THROUGH : MotionOrder.Form.SPLINE,
        machine.next().spline().settings(),
        null);
  }

  private static Statement.MotionKind kind(Statement.SplineKind kind) {
    return switch (kind) {
      case SPTP -> Statement.MotionKind.PTP;
      case SPTP_REL -> Statement.MotionKind.PTP_REL;
      case SLIN, SPL -> Statement.MotionKind.LIN;
      case SLIN_REL, SPL_REL -> Statement.MotionKind.LIN_REL;
      case SCIRC -> Statement.MotionKind.CIRC;
      case SCIRC_REL -> Statement.MotionKind.CIRC_REL;
    };
  }

  private static @Nullable String constant(@Nullable String coordinates) {
    return coordinates == null ? null : coordinates.replace("#", "").toUpperCase(Locale.ROOT);
  }

  private static String pointName(Expression target) {
    return target instanceof Expression.Variable variable ? variable.name() : "";
  }

  /** Compiles a motion. The caller has compiled the stop of the advance run. */
  void motion(Statement.MotionStatement motion) {
    Position position = motion.position();
    // the target is evaluated when the motion can be planned (assumed)
    code.emit(position, KrlVirtualMachine::awaitAdvance);
    points(motion.auxiliary(), motion.target(), motion.circularAngle());
    code.emit(position, machine -> machine.environment().move(order(machine, motion)));
    code.emit(position, KrlVirtualMachine::awaitMotionWithoutAdvance);
  }

  private static MotionOrder order(KrlVirtualMachine machine, Statement.MotionStatement motion)
      throws KrlExecutionException {
    Points points = Points.pop(machine, motion.auxiliary(), motion.circularAngle());
    return new MotionOrder(
        motion.kind(),
        points.auxiliary(),
        points.target(),
        points.circularAngle(),
        motion.approximations(),
        constant(motion.coordinates()),
        pointName(motion.target()),
        machine.module(),
        motion.position(),
        machine.next().takeTriggers());
  }
}
