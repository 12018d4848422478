package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.Statement;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.data.Operators;
import no.hials.crosscom.simulator.internal.data.Scope;
import no.hials.crosscom.simulator.internal.data.VariablePath;
import org.jspecify.annotations.Nullable;

/**
 * Compiles the statements of a routine. Each statement leaves the stack as it was.
 *
 * <p>The class is long, because it has a method for each kind of statement.
 */
final class StatementCompiler {
  private static final TypeSwitch<StatementCompiler, Statement, Void, RuntimeException> STATEMENTS =
      TypeSwitch.create(
          Statement.class,
          cases ->
              cases
                  .run(Statement.AssignmentStatement.class, StatementCompiler::assignment)
                  .run(Statement.CallStatement.class, StatementCompiler::call)
                  .run(Statement.Pulse.class, StatementCompiler::pulse)
                  .run(Statement.If.class, StatementCompiler::branch)
                  .run(Statement.Switch.class, StatementCompiler::branch)
                  .run(Statement.For.class, StatementCompiler::loop)
                  .run(Statement.While.class, StatementCompiler::loop)
                  .run(Statement.Repeat.class, StatementCompiler::loop)
                  .run(Statement.Loop.class, StatementCompiler::loop)
                  .run(
                      Statement.Exit.class,
                      (c, it) -> c.code.jump(it.position(), c.loopEnds.element()))
                  .run(
                      Statement.Goto.class,
                      (c, it) -> c.code.jump(it.position(), c.label(it.label())))
                  .run(Statement.Label.class, (c, it) -> c.code.mark(c.label(it.name())))
                  .run(Statement.Return.class, StatementCompiler::leave)
                  .run(Statement.Halt.class, StatementCompiler::halt)
                  .run(Statement.Continue.class, (c, it) -> {}) // see statements()
                  .run(Statement.WaitFor.class, StatementCompiler::waitFor)
                  .run(Statement.WaitSec.class, StatementCompiler::waitSeconds)
                  .run(Statement.InterruptDeclaration.class, StatementCompiler::declare)
                  .run(Statement.Interrupt.class, StatementCompiler::interrupt)
                  .run(
                      Statement.Resume.class,
                      (c, it) -> c.code.emit(it.position(), KrlVirtualMachine::resume))
                  .run(
                      Statement.Brake.class,
                      (c, it) -> c.code.emit(it.position(), machine -> machine.brake(it.maximum())))
                  .run(Statement.MotionStatement.class, StatementCompiler::motion)
                  .run(Statement.Trigger.class, (c, it) -> c.motions.trigger(it))
                  .run(Statement.SplineMotion.class, StatementCompiler::spline)
                  .run(Statement.SplineBlock.class, StatementCompiler::block)
                  .run(Statement.TimeBlock.class, (c, it) -> c.unsupported(it, "TIME_BLOCK"))
                  .run(Statement.ConstantVelocity.class, (c, it) -> c.unsupported(it, "CONST_VEL"))
                  .run(Statement.StopOnPath.class, (c, it) -> c.motions.stop(it))
                  .run(Statement.OnErrorProceed.class, (c, it) -> {}) // see statements()
                  .run(Statement.Confirm.class, StatementCompiler::confirm)
                  .run(Statement.AnalogInput.class, StatementCompiler::analogInput)
                  .run(Statement.AnalogOutput.class, StatementCompiler::analogOutput)
                  .run(Statement.Invalid.class, StatementCompiler::stop));

  /** Compiles an action without the stop of the advance run. */
  private static final TypeSwitch<StatementCompiler, Statement.Action, Void, RuntimeException>
      ACTIONS =
          TypeSwitch.create(
              Statement.Action.class,
              cases ->
                  cases
                      .run(Statement.AssignmentStatement.class, StatementCompiler::assign)
                      .run(
                          Statement.CallStatement.class,
                          (c, it) ->
                              c.expressions.call(it.position(), it.name(), it.arguments(), false))
                      .run(Statement.Pulse.class, StatementCompiler::sendPulse));

  /** The statements without jumps, labels and temporary values. */
  private static final Set<Class<? extends Statement>> STRAIGHT =
      Set.of(
          Statement.AssignmentStatement.class,
          Statement.CallStatement.class,
          Statement.Pulse.class,
          Statement.Halt.class,
          Statement.WaitSec.class,
          Statement.InterruptDeclaration.class,
          Statement.Interrupt.class,
          Statement.MotionStatement.class,
          Statement.Trigger.class,
          Statement.SplineMotion.class,
          Statement.SplineBlock.class,
          Statement.StopOnPath.class,
          Statement.Confirm.class,
          Statement.AnalogInput.class,
          Statement.AnalogOutput.class);

  private static final KrlInt ZERO = new KrlInt(0);
  private static final KrlInt ONE = new KrlInt(1);

  private final RoutineContext context;
  private final boolean function;
  private final CodeBuilder code;
  private final ExpressionCompiler expressions;
  private final MotionCompiler motions;
  private final Deque<CodeBuilder.Label> loopEnds = new ArrayDeque<>();
  private final Map<String, CodeBuilder.Label> labels = new HashMap<>();

  /** Whether CONTINUE precedes the statement. */
  private boolean goOn;

  /** Whether the routine is BAS, the branches of which are the commands that programs give. */
  private boolean bas;

  /**
   * @param function whether the routine is a function
   */
  StatementCompiler(RoutineContext context, boolean function) {
    this.context = context;
    this.function = function;
    this.code = new CodeBuilder();
    this.expressions = new ExpressionCompiler(context, code, null);
    this.motions = new MotionCompiler(code, expressions, new MotionParts());
  }

  CompiledCode routine(String name, List<Statement> body, Position end) {
    bas = Scope.key(name).equals("BAS");
    statements(body);
    code.statement();
    if (function) {
      code.emit(
          end,
          machine -> {
            throw new KrlExecutionException(
                KrlExecutionException.NO_RESULT,
                "function " + name + " must end with RETURN and a value");
          });
    } else {
      code.emit(end, KrlVirtualMachine::returnNothing);
    }
    return code.build();
  }

  private void statements(List<Statement> body) {
    goOn = false;
    CodeBuilder.Label afterProtected = null;
    CompiledCode.@Nullable Statements straight = null;
    for (int i = 0; i < body.size(); i++) {
      Statement statement = body.get(i);
      code.statement();
      if (!goOn && STRAIGHT.contains(statement.getClass())) {
        straight = straight(body, i, straight);
      } else {
        straight = null;
        stopAtError(statement.position(), () -> STATEMENTS.run(this, statement));
      }
      goOn = statement instanceof Statement.Continue;
      if (afterProtected != null) {
        code.mark(afterProtected);
        context.leaveBranch();
      }
      afterProtected = null;
      if (statement instanceof Statement.OnErrorProceed) {
        afterProtected = proceed(statement);
        // the routine continues after an error
        context.enterBranch();
      }
    }
    if (afterProtected != null) {
      code.mark(afterProtected);
      context.leaveBranch();
    }
  }

  /**
   * Checks a statement without jumps, which is compiled when it is reached.
   *
   * @param before the statements before it; null if there are none
   * @return the statements that the next one can join
   */
  private CompiledCode.@Nullable Statements straight(
      List<Statement> body, int index, CompiledCode.@Nullable Statements before) {
    Statement statement = body.get(index);
    // its code is created again when it is reached
    StatementCompiler check = new StatementCompiler(context, function);
    String error = context.compile(() -> STATEMENTS.run(check, statement));
    if (error != null) {
      context.stopsAt(statement.position(), error);
      code.stop(code.size(), statement.position(), KrlExecutionException.NOT_ALLOWED, error);
      return null;
    } else if (check.code.size() == 0) {
      return null;
    }
    int first = code.size() - index;
    CompiledCode.Statements statements =
        before == null
            ? new CompiledCode.Statements(slot -> compile(body.get(slot - first)))
            : before;
    code.emit(statements);
    return statements;
  }

  private List<CompiledCode.Step> compile(Statement statement) {
    StatementCompiler compiler = new StatementCompiler(context, function);
    compiler.stopAtError(statement.position(), () -> STATEMENTS.run(compiler, statement));
    if (compiler.code.size() == 0) {
      compiler.code.emit(statement.position(), machine -> {});
    }
    return compiler.code.steps();
  }

  /** Protects the next statement; returns where the program continues after an error in it. */
  private CodeBuilder.Label proceed(Statement statement) {
    CodeBuilder.Label after = new CodeBuilder.Label();
    int protectedStatement = code.size() + 1;
    code.emit(
        statement.position(),
        machine -> {
          machine.environment().error(0);
          machine.frame().proceed(protectedStatement, after.target());
        });
    return after;
  }

  /** Compiles a statement or a part of it; the program stops there if it has an error. */
  private void stopAtError(Position position, Runnable compilation) {
    int begin = code.size();
    String error = context.compile(compilation);
    if (error != null) {
      context.stopsAt(position, error);
      code.stop(begin, position, KrlExecutionException.NOT_ALLOWED, error);
    }
  }

  private void unsupported(Statement statement, String word) {
    context.error(statement.position(), word + " is not supported by this simulation");
  }

  /** Compiles a line that could not be parsed: the program stops there. */
  private void stop(Statement.Invalid invalid) {
    context.stopsAt(invalid.position(), invalid.reason());
    code.emit(
        invalid.position(),
        machine -> {
          throw new KrlExecutionException(KrlExecutionException.NOT_ALLOWED, invalid.reason());
        });
  }

  // the advance run

  private void await(Position position) {
    if (!goOn) {
      code.emit(position, KrlVirtualMachine::awaitMotion);
    }
  }

  /** Stops the advance run if one of the expressions requires it. */
  private void awaitFor(Position position, @Nullable Expression... used) {
    if (context.stopAdvanceRun(Arrays.asList(used))) {
      await(position);
    }
  }

  // assignment, call, PULSE

  private void assignment(Statement.AssignmentStatement assignment) {
    awaitFor(assignment.position(), assignment.target(), assignment.value());
    assign(assignment);
  }

  private void call(Statement.CallStatement call) {
    awaitFor(call.position(), call.arguments().toArray(new Expression[0]));
    ACTIONS.run(this, call);
  }

  private void pulse(Statement.Pulse pulse) {
    await(pulse.position());
    sendPulse(pulse);
  }

  private void assign(Statement.AssignmentStatement assignment) {
    if (Scope.key(assignment.target().name()).equals("$CYCFLAG")) {
      CompiledCode value = cyclic("a cyclic flag", assignment.value());
      expressions.reference(assignment.target());
      code.emit(
          assignment.position(),
          machine ->
              machine
                  .cyclic()
                  .start(machine.popReference(), value, CyclicAssignments.Shape.NONE, machine));
      return;
    }
    expressions.write(assignment.target(), () -> expressions.compile(assignment.value()));
  }

  /** Compiles an expression that is evaluated in each cycle. */
  private CompiledCode cyclic(String what, Expression expression) {
    CodeBuilder builder = new CodeBuilder();
    new ExpressionCompiler(context, builder, what).compile(expression);
    return builder.build();
  }

  private void analogInput(Statement.AnalogInput input) {
    analog(input.position(), "ANIN", input.target(), input.value(), null, null, null);
  }

  private void analogOutput(Statement.AnalogOutput output) {
    analog(
        output.position(),
        "ANOUT",
        output.target(),
        output.value(),
        output.delay(),
        output.minimum(),
        output.maximum());
  }

  private void analog(
      Position position,
      String word,
      Expression.Variable target,
      @Nullable Expression value,
      @Nullable Expression delay,
      @Nullable Expression minimum,
      @Nullable Expression maximum) {
    expressions.reference(target);
    if (value == null) {
      code.emit(position, machine -> machine.cyclic().end(machine.popReference()));
      return;
    }
    CompiledCode compiled = cyclic(word, value);
    expressions.compileOr(position, delay, KrlReal.of(0));
    expressions.compileOr(position, minimum, KrlReal.of(-Float.MAX_VALUE));
    expressions.compileOr(position, maximum, KrlReal.of(Float.MAX_VALUE));
    code.emit(
        position,
        machine -> {
          double highest = machine.popNumber();
          double lowest = machine.popNumber();
          CyclicAssignments.Shape shape =
              new CyclicAssignments.Shape(machine.popNumber(), lowest, highest);
          machine.cyclic().start(machine.popReference(), compiled, shape, machine);
        });
  }

  private void confirm(Statement.Confirm confirm) {
    expressions.compile(confirm.message());
    code.emit(
        confirm.position(), machine -> machine.environment().messages().confirm(machine.popInt()));
  }

  private void sendPulse(Statement.Pulse pulse) {
    if (context.symbols().resolve(pulse.signal()) == null) {
      return;
    }
    OptionalInt wired = context.symbols().output(pulse.signal().name());
    boolean direct = Scope.key(pulse.signal().name()).equals("$OUT");
    if (direct ? SymbolTable.isWholeArray(pulse.signal()) : wired.isEmpty()) {
      context.error(pulse.position(), "PULSE takes one output, was given " + pulse.signal().name());
      return;
    }
    ExpressionCompiler.PathSource source = expressions.path(pulse.signal());
    expressions.compile(pulse.level());
    expressions.compile(pulse.seconds());
    code.emit(
        pulse.position(),
        machine -> {
          double seconds = machine.popNumber();
          boolean level = machine.popBool();
          VariablePath path = source.take(machine);
          int output = direct ? path.first().index().number(0) : wired.getAsInt();
          machine.environment().pulse(output, level, seconds);
        });
  }

  /** Compiles the action of an interrupt or a trigger, which uses the variables of the routine. */
  private CompiledCode detached(Statement.Action action) {
    StatementCompiler compiler = new StatementCompiler(context, false);
    context.enterBranch();
    compiler.stopAtError(action.position(), () -> ACTIONS.run(compiler, action));
    context.leaveBranch();
    compiler.code.emit(action.position(), KrlVirtualMachine::returnNothing);
    return compiler.code.build();
  }

  // branches and loops

  private void condition(Position position, Expression condition) {
    awaitFor(position, condition);
    expressions.compile(condition);
  }

  private void branch(Statement.If branch) {
    Position position = branch.position();
    CodeBuilder.Label otherwise = new CodeBuilder.Label();
    CodeBuilder.Label end = new CodeBuilder.Label();
    condition(position, branch.condition());
    code.jumpUnless(position, otherwise);
    nested(branch.then());
    if (!branch.otherwise().isEmpty()) {
      code.statement();
      code.jump(position, end);
    }
    code.mark(otherwise);
    nested(branch.otherwise());
    code.mark(end);
  }

  private void branch(Statement.Switch branch) {
    Position position = branch.position();
    int selector = context.newTemporary();
    CodeBuilder.Label end = new CodeBuilder.Label();
    List<CodeBuilder.Label> bodies = new ArrayList<>();
    condition(position, branch.selector());
    code.emit(position, machine -> machine.frame().setTemporary(selector, machine.pop()));
    for (Statement.Case branchCase : branch.cases()) {
      CodeBuilder.Label body = new CodeBuilder.Label();
      bodies.add(body);
      for (Expression value : branchCase.values()) {
        expressions.compile(value);
        code.emit(
            value.position(),
            machine ->
                machine.push(
                    new KrlBool(
                        Operators.areEqual(machine.frame().temporary(selector), machine.pop()))));
        code.jumpIf(value.position(), body);
      }
    }
    if (branch.otherwise() != null) {
      nested(branch.otherwise());
    }
    code.statement();
    code.jump(position, end);
    for (int i = 0; i < bodies.size(); i++) {
      code.mark(bodies.get(i));
      Statement.Case branchCase = branch.cases().get(i);
      if (bas && branchCase.values().stream().anyMatch(Bas::isSimulated)) {
        statements(branchCase.body());
      } else {
        nested(branchCase.body());
      }
      code.statement();
      code.jump(position, end);
    }
    code.mark(end);
  }

  private void nested(List<Statement> body) {
    context.enterBranch();
    statements(body);
    context.leaveBranch();
  }

  /** Compiles the body of a loop; EXIT jumps to a label. */
  private void body(List<Statement> body, CodeBuilder.Label end) {
    loopEnds.push(end);
    nested(body);
    loopEnds.pop();
  }

  /** Counts up to the last value, included. TO and STEP are evaluated once, at the start. */
  private void loop(Statement.For loop) {
    Position position = loop.position();
    int last = context.newTemporary();
    int step = context.newTemporary();
    CodeBuilder.Label turn = new CodeBuilder.Label();
    CodeBuilder.Label end = new CodeBuilder.Label();
    awaitFor(position, loop.from(), loop.to(), loop.step());
    expressions.write(loop.counter(), () -> expressions.compile(loop.from()));
    integer(loop.to(), last);
    if (loop.step() == null) {
      code.emit(position, machine -> machine.frame().setTemporary(step, ONE));
    } else {
      integer(loop.step(), step);
      code.emit(loop.step().position(), machine -> checkStep(machine.frame().temporary(step)));
    }
    code.statement();
    code.mark(turn);
    expressions.compile(loop.counter());
    code.emit(position, machine -> machine.push(goesOn(machine, last, step)));
    code.jumpUnless(position, end);
    body(loop.body(), end);
    code.statement();
    expressions.write(
        loop.counter(),
        () -> {
          expressions.compile(loop.counter());
          code.emit(position, machine -> count(machine, step));
        });
    code.jump(position, turn);
    code.mark(end);
  }

  private void integer(Expression expression, int temporary) {
    expressions.compile(expression);
    code.emit(
        expression.position(),
        machine -> machine.frame().setTemporary(temporary, new KrlInt(machine.popInt())));
  }

  private static void checkStep(KrlValue step) throws KrlExecutionException {
    if (step.equals(ZERO)) {
      // assumed
      throw new KrlExecutionException(
          KrlExecutionException.OUT_OF_RANGE, "the STEP of FOR must not be 0");
    }
  }

  private static KrlBool goesOn(KrlVirtualMachine machine, int last, int step)
      throws KrlExecutionException {
    int counter = machine.popInt();
    int end = ((KrlInt) machine.frame().temporary(last)).value();
    boolean down = ((KrlInt) machine.frame().temporary(step)).value() < 0;
    return new KrlBool(down ? counter >= end : counter <= end);
  }

  private static void count(KrlVirtualMachine machine, int step) throws KrlExecutionException {
    int width = ((KrlInt) machine.frame().temporary(step)).value();
    machine.push(Operators.integer((long) machine.popInt() + width));
  }

  private void loop(Statement.While loop) {
    Position position = loop.position();
    CodeBuilder.Label turn = new CodeBuilder.Label();
    CodeBuilder.Label end = new CodeBuilder.Label();
    code.mark(turn);
    condition(position, loop.condition());
    code.jumpUnless(position, end);
    body(loop.body(), end);
    code.statement();
    code.jump(position, turn);
    code.mark(end);
  }

  private void loop(Statement.Repeat loop) {
    CodeBuilder.Label turn = new CodeBuilder.Label();
    CodeBuilder.Label end = new CodeBuilder.Label();
    boolean conditionGoesOn = goOn;
    code.mark(turn);
    body(loop.body(), end);
    code.statement();
    goOn = conditionGoesOn;
    stopAtError(loop.until().position(), () -> condition(loop.until().position(), loop.until()));
    code.jumpUnless(loop.until().position(), turn);
    code.mark(end);
  }

  private void loop(Statement.Loop loop) {
    CodeBuilder.Label turn = new CodeBuilder.Label();
    CodeBuilder.Label end = new CodeBuilder.Label();
    code.mark(turn);
    body(loop.body(), end);
    code.statement();
    code.jump(loop.position(), turn);
    code.mark(end);
  }

  /** Returns the target of a label, which can precede or follow its jumps. */
  private CodeBuilder.Label label(String name) {
    return labels.computeIfAbsent(Scope.key(name), key -> new CodeBuilder.Label());
  }

  private void leave(Statement.Return leave) {
    Position position = leave.position();
    if (leave.value() == null) {
      code.emit(position, KrlVirtualMachine::returnNothing);
      return;
    }
    condition(position, leave.value());
    code.emit(position, machine -> machine.returnValue(machine.pop()));
  }

  // waiting

  private void halt(Statement.Halt halt) {
    code.emit(halt.position(), KrlVirtualMachine::awaitMotion);
    code.emit(halt.position(), KrlVirtualMachine::halt);
  }

  private void waitFor(Statement.WaitFor wait) {
    Position position = wait.position();
    CodeBuilder.Label look = new CodeBuilder.Label();
    CodeBuilder.Label end = new CodeBuilder.Label();
    await(position);
    code.mark(look);
    expressions.compile(wait.condition());
    code.jumpIf(position, end);
    code.emit(position, KrlVirtualMachine::awaitCondition);
    code.jump(position, look);
    code.mark(end);
  }

  private void waitSeconds(Statement.WaitSec wait) {
    Position position = wait.position();
    await(position);
    expressions.compile(wait.seconds());
    code.emit(
        position,
        machine ->
            machine.frame().setDeadline(machine.environment().timeAfter(machine.popNumber())));
    code.emit(
        position,
        machine -> {
          if (machine.environment().time() < machine.frame().deadline()) {
            machine.again();
          }
        });
  }

  // interrupts

  private void declare(Statement.InterruptDeclaration declaration) {
    CompiledCode condition = cyclic("the condition of an interrupt", declaration.condition());
    CompiledCode action = detached(declaration.action());
    expressions.compile(declaration.priority());
    code.emit(
        declaration.position(),
        machine ->
            machine
                .interrupts()
                .declare(
                    new Interrupts.Declaration(
                        machine.popInt(), declaration.global(), condition, action),
                    machine.frame()));
  }

  private void interrupt(Statement.Interrupt interrupt) {
    Position position = interrupt.position();
    if (interrupt.priority() == null) {
      code.emit(position, machine -> machine.interrupts().commandAll(interrupt.command(), machine));
      return;
    }
    expressions.compile(interrupt.priority());
    code.emit(
        position,
        machine -> machine.interrupts().command(interrupt.command(), machine.popInt(), machine));
  }

  // motions

  /** The methods that the compiler of motions uses. */
  private final class MotionParts implements MotionCompiler.Statements {
    @Override
    public void assign(Statement.AssignmentStatement assignment) {
      StatementCompiler.this.assign(assignment);
    }

    @Override
    public CompiledCode detached(Statement.Action action) {
      return StatementCompiler.this.detached(action);
    }

    @Override
    public CompiledCode condition(Expression condition) {
      return cyclic("a condition on the path", condition);
    }
  }

  private void spline(Statement.SplineMotion motion) {
    awaitFor(motion);
    motions.spline(motion);
  }

  private void awaitFor(Statement.SplineMotion motion) {
    awaitFor(motion.position(), motion.auxiliary(), motion.target(), motion.circularAngle());
    awaitFor(motion.with());
  }

  private void awaitFor(List<Statement.AssignmentStatement> with) {
    with.forEach(it -> awaitFor(it.position(), it.target(), it.value()));
  }

  private void block(Statement.SplineBlock block) {
    awaitFor(block.with());
    for (Statement.SplineElement element : block.elements()) {
      if (element instanceof Statement.SplineMotion segment) {
        awaitFor(segment);
      }
    }
    motions.block(block);
  }

  private void motion(Statement.MotionStatement motion) {
    awaitFor(motion.position(), motion.auxiliary(), motion.target(), motion.circularAngle());
    motions.motion(motion);
  }
}
