package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.RefusedException;
import no.hials.crosscom.simulator.internal.data.Index;
import no.hials.crosscom.simulator.internal.data.Operators;
import no.hials.crosscom.simulator.internal.data.Scope;
import no.hials.crosscom.simulator.internal.data.VariablePath;
import org.jspecify.annotations.Nullable;

/** Compiles expressions to instructions that leave the value on the stack. */
final class ExpressionCompiler {
  private static final TypeSwitch<ExpressionCompiler, Expression, Void, RuntimeException>
      EXPRESSIONS =
          TypeSwitch.create(
              Expression.class,
              cases ->
                  cases
                      .run(
                          Expression.IntLiteral.class,
                          (c, it) -> c.code.constant(it.position(), new KrlInt(it.value())))
                      .run(Expression.RealLiteral.class, ExpressionCompiler::real)
                      .run(
                          Expression.BoolLiteral.class,
                          (c, it) -> c.code.constant(it.position(), new KrlBool(it.value())))
                      .run(
                          Expression.TextLiteral.class,
                          (c, it) -> c.code.constant(it.position(), new KrlString(it.text())))
                      .run(
                          Expression.EnumLiteral.class,
                          (c, it) -> c.code.constant(it.position(), new KrlEnum(it.name())))
                      .run(
                          Expression.ChannelLiteral.class,
                          (c, it) -> c.context.error(it.position(), "channels are not simulated"))
                      .run(Expression.Aggregate.class, ExpressionCompiler::aggregate)
                      .run(Expression.Variable.class, ExpressionCompiler::read)
                      .run(
                          Expression.FunctionCall.class,
                          (c, it) -> c.call(it.position(), it.name(), it.arguments(), true))
                      .run(Expression.Unary.class, ExpressionCompiler::unary)
                      .run(Expression.Binary.class, ExpressionCompiler::binary));

  private final RoutineContext context;
  private final CodeBuilder code;
  private final @Nullable String cyclic;

  /**
   * @param code gets the instructions
   * @param cyclic what evaluates the expressions in each cycle, so that they cannot call routines
   *     with a source; null otherwise
   */
  ExpressionCompiler(RoutineContext context, CodeBuilder code, @Nullable String cyclic) {
    this.context = context;
    this.code = code;
    this.cyclic = cyclic;
  }

  /** Returns the path of a part of a variable; takes its indices from the stack. */
  @FunctionalInterface
  interface PathSource {
    VariablePath take(KrlVirtualMachine machine) throws KrlExecutionException;
  }

  void compile(Expression expression) {
    EXPRESSIONS.run(this, expression);
  }

  /** Compiles an expression that can be omitted. */
  void compileOr(Position position, @Nullable Expression expression, KrlValue otherwise) {
    if (expression == null) {
      code.constant(position, otherwise);
    } else {
      compile(expression);
    }
  }

  private void real(Expression.RealLiteral literal) {
    try {
      code.constant(literal.position(), Operators.real(literal.value()));
    } catch (KrlExecutionException e) {
      context.error(literal.position(), String.valueOf(e.getMessage()));
    }
  }

  private void unary(Expression.Unary unary) {
    compile(unary.operand());
    Position position = unary.position();
    switch (unary.operator()) {
      case PLUS -> code.emit(position, m -> m.push(Operators.positive(m.pop())));
      case MINUS -> code.emit(position, m -> m.push(Operators.negative(m.pop())));
      case NOT -> code.emit(position, m -> m.push(Operators.not(m.pop())));
      case B_NOT -> code.emit(position, m -> m.push(Operators.bitwiseNot(m.pop())));
    }
  }

  private void binary(Expression.Binary binary) {
    compile(binary.left());
    compile(binary.right());
    Operators.Operator operator = Operators.of(binary.operator());
    code.emit(
        binary.position(),
        machine -> {
          KrlValue right = machine.pop();
          machine.push(operator.apply(machine.pop(), right));
        });
  }

  private void aggregate(Expression.Aggregate aggregate) {
    List<String> names = new ArrayList<>();
    for (Expression.AggregateField field : aggregate.fields()) {
      compile(field.value());
      names.add(field.name());
    }
    code.emit(
        aggregate.position(), machine -> machine.push(struct(aggregate.type(), names, machine)));
  }

  private static KrlStruct struct(
      @Nullable String type, List<String> names, KrlVirtualMachine machine)
      throws KrlExecutionException {
    KrlValue[] values = new KrlValue[names.size()];
    for (int i = values.length - 1; i >= 0; i--) {
      values[i] = machine.pop();
    }
    try {
      List<KrlStruct.Field> fields = new ArrayList<>(values.length);
      for (int i = 0; i < values.length; i++) {
        fields.add(new KrlStruct.Field(names.get(i), values[i]));
      }
      return new KrlStruct(type, fields);
    } catch (IllegalArgumentException e) {
      throw new KrlExecutionException(
          KrlExecutionException.WRONG_TYPE, String.valueOf(e.getMessage()));
    }
  }

  // variables

  private void read(Expression.Variable variable) {
    StorageLocation location = context.symbols().resolve(variable);
    if (location != null) {
      PathSource source = path(variable);
      code.emit(
          variable.position(),
          machine -> machine.push(location.read(machine.frame(), source.take(machine))));
    }
  }

  /**
   * Compiles an assignment.
   *
   * @param value compiles the value, after the indices of the target
   */
  void write(Expression.Variable target, Runnable value) {
    StorageLocation location = context.symbols().resolve(target);
    PathSource source = path(target);
    value.run();
    if (location != null) {
      code.emit(
          target.position(),
          machine -> {
            KrlValue assigned = machine.pop();
            location.write(machine.frame(), source.take(machine), assigned);
          });
    }
  }

  /** Compiles the indices of a variable. */
  PathSource path(Expression.Variable variable) {
    VariablePath path =
        VariablePath.of(
            variable, index -> index instanceof Expression.IntLiteral it ? it.value() : 0);
    boolean constant =
        variable.steps().stream()
            .flatMap(step -> step.indices().stream())
            .allMatch(Expression.IntLiteral.class::isInstance);
    if (constant) {
      return machine -> path;
    }
    variable.steps().forEach(step -> step.indices().forEach(this::compile));
    return machine -> indexed(path.steps(), machine);
  }

  private static VariablePath indexed(List<VariablePath.PathStep> steps, KrlVirtualMachine machine)
      throws KrlExecutionException {
    VariablePath.PathStep[] result = new VariablePath.PathStep[steps.size()];
    for (int i = result.length - 1; i >= 0; i--) {
      VariablePath.PathStep step = steps.get(i);
      int[] numbers = new int[step.index().count()];
      if (numbers.length == 0) {
        result[i] = step;
        continue;
      }
      for (int n = numbers.length - 1; n >= 0; n--) {
        numbers[n] = machine.popInt();
      }
      result[i] = new VariablePath.PathStep(step.name(), new Index(numbers, step.index().isOpen()));
    }
    return new VariablePath(List.of(result));
  }

  // calls

  /**
   * Compiles a call.
   *
   * @param valueWanted whether the call leaves the value of a function on the stack
   */
  void call(
      Position position,
      String name,
      List<? extends @Nullable Expression> arguments,
      boolean valueWanted) {
    String key = Scope.key(name);
    CompiledRoutine routine = context.routine(name);
    Builtin builtin = Builtins.find(key);
    if (routine != null) {
      call(position, routine, arguments, valueWanted);
      return;
    }
    if (builtin != null) {
      call(position, builtin, arguments, valueWanted);
      return;
    }
    CompiledRoutine builtIn = context.builtInRoutine(name);
    if (builtIn != null) {
      call(position, builtIn, arguments, valueWanted);
    } else if (!(AbsentRoutines.isHook(key) && !valueWanted)) {
      absent(position, name);
    }
  }

  /** Compiles a call of a routine that does not exist, with arguments of unknown kinds. */
  private void absent(Position position, String name) {
    KrlExecutionException reached = AbsentRoutines.reached(Scope.key(name));
    if (reached == null) {
      context.error(position, "no routine " + name + " is known");
      return;
    }
    code.emit(
        position,
        machine -> {
          throw reached;
        });
  }

  private void checkValue(Position position, String name, boolean function, boolean valueWanted) {
    if (valueWanted && !function) {
      context.error(position, name + " is a subprogram and has no value");
    }
  }

  private void call(
      Position position,
      CompiledRoutine routine,
      List<? extends @Nullable Expression> arguments,
      boolean valueWanted) {
    checkValue(position, routine.name(), routine.isFunction(), valueWanted);
    if (cyclic != null) {
      // assumed: the condition is evaluated in every cycle and cannot wait
      context.error(position, cyclic + " must not call " + routine.name());
    }
    List<CompiledRoutine.Parameter> parameters = routine.parameters();
    if (arguments.size() > parameters.size()) {
      context.error(
          position,
          routine.name() + " takes " + parameters.size() + " arguments, has " + arguments.size());
      return;
    }
    for (int i = 0; i < parameters.size(); i++) {
      argument(position, parameters.get(i), i < arguments.size() ? arguments.get(i) : null);
    }
    code.emit(position, machine -> machine.call(routine, valueWanted));
  }

  private void argument(
      Position position, CompiledRoutine.Parameter parameter, @Nullable Expression argument) {
    if (argument == null) {
      code.emit(position, machine -> machine.push(null));
    } else if (parameter.out() && argument instanceof Expression.Variable variable) {
      reference(variable);
    } else if (parameter.array()) {
      contents(argument);
    } else {
      compile(argument);
    }
  }

  void reference(Expression.Variable variable) {
    StorageLocation location = context.symbols().resolve(variable);
    if (location != null) {
      PathSource source = path(variable);
      code.emit(
          variable.position(),
          machine -> {
            VariablePath path = source.take(machine);
            machine.push(new Reference(location, machine.frame(), path));
          });
    }
  }

  /** Passes a copy of an array. */
  private void contents(Expression argument) {
    Position position = argument.position();
    if (argument instanceof Expression.TextLiteral || argument instanceof Expression.FunctionCall) {
      compile(argument);
    } else if (argument instanceof Expression.Variable variable) {
      StorageLocation location = context.symbols().resolve(variable);
      if (location != null) {
        PathSource source = path(variable);
        code.emit(position, machine -> pushContents(machine, location, source.take(machine)));
      }
    } else {
      context.error(position, "an argument for an array is a variable or a text");
    }
  }

  private static void pushContents(
      KrlVirtualMachine machine, StorageLocation location, VariablePath path)
      throws KrlExecutionException {
    try {
      machine.push(location.storage(machine.frame(), path));
    } catch (RefusedException e) {
      throw KrlExecutionException.of(location.name(machine.frame(), path), e);
    }
  }

  private void call(
      Position position,
      Builtin builtin,
      List<? extends @Nullable Expression> arguments,
      boolean valueWanted) {
    checkValue(position, builtin.name(), builtin.function(), valueWanted);
    int most = builtin.parameters().size();
    int least = most - builtin.optional();
    boolean complete = arguments.stream().limit(least).allMatch(argument -> argument != null);
    if (arguments.size() < least || arguments.size() > most || !complete) {
      context.error(
          position,
          builtin.name()
              + " takes "
              + (least == most ? "" : least + " to ")
              + most
              + " arguments, has "
              + arguments.stream().filter(argument -> argument != null).count());
      return;
    }
    for (int i = 0; i < most; i++) {
      Expression argument = i < arguments.size() ? arguments.get(i) : null;
      if (argument == null) {
        code.emit(position, machine -> machine.push(null));
      } else {
        argument(builtin.parameters().get(i), argument);
      }
    }
    if (MessageBuiltins.shows(builtin)) {
      code.emit(position, MessageBuiltins::await);
    }
    code.emit(position, machine -> execute(machine, builtin, valueWanted));
  }

  private void argument(Builtin.Kind kind, Expression argument) {
    boolean isText =
        argument instanceof Expression.TextLiteral || argument instanceof Expression.FunctionCall;
    if (kind == Builtin.Kind.VALUE || (kind == Builtin.Kind.TEXT && isText)) {
      compile(argument);
    } else if (argument instanceof Expression.Variable variable) {
      reference(variable);
    } else {
      context.error(argument.position(), "an argument for an :OUT parameter is a variable");
    }
  }

  private void execute(KrlVirtualMachine machine, Builtin builtin, boolean valueWanted)
      throws KrlExecutionException {
    @Nullable Object[] arguments = new Object[builtin.parameters().size()];
    for (int i = arguments.length - 1; i >= 0; i--) {
      arguments[i] = machine.popArgument();
    }
    KrlValue value =
        builtin.run(new Builtin.Call(machine, context.symbols(), Arrays.asList(arguments)));
    if (valueWanted) {
      machine.push(value);
    }
  }
}
