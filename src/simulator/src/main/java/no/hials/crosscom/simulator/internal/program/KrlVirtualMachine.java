package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.RefusedException;
import no.hials.crosscom.simulator.internal.data.Operators;
import no.hials.crosscom.simulator.internal.data.Storage;
import no.hials.crosscom.simulator.internal.data.VariablePath;
import no.hials.crosscom.simulator.internal.program.KrlInterpreter.LineStep;
import org.jspecify.annotations.Nullable;

/**
 * Executes instructions. An instruction that has to wait is executed again in the next cycle, so it
 * must decide to wait before it has any effect. The class is long because instructions, interrupts
 * and errors work on its one stack of calls.
 */
final class KrlVirtualMachine {
  /** The maximum depth of calls (assumed). */
  static final int MAX_CALLS = 256;

  private static final int FIRST_STACK_LENGTH = 64;

  /** The priority of the program itself, which any interruption interrupts. */
  private static final int LOWEST_PRIORITY = Integer.MAX_VALUE;

  private static final VariablePath RESULT = VariablePath.of("RESULT");
  private static final VariablePath RESULT_ARRAY = RESULT.whole();

  private final Interpreter kind;
  private final ProgramEnvironment environment;
  private final Interrupts interrupts = new Interrupts();
  private final CyclicAssignments cyclic = new CyclicAssignments();
  private final NextMotion next = new NextMotion();

  /** Values, references and contents of variables; null for an omitted argument. */
  private @Nullable Object[] stack = new Object[FIRST_STACK_LENGTH];

  private int height;
  private int calls;
  private @Nullable CallFrame top;
  private boolean waiting;
  private boolean waitsForCondition;
  private boolean halted;
  private int executed;

  /** The frame and the instruction at which the line began that is executed alone. */
  private @Nullable CallFrame lineFrame;

  private int lineInstruction;

  /** The position of a fault in a condition; null if the fault is in the current statement. */
  private @Nullable Position faultPosition;

  KrlVirtualMachine(Interpreter kind, ProgramEnvironment environment) {
    this.kind = kind;
    this.environment = environment;
  }

  // for the interpreter

  /** Removes the program and its state. */
  void clear() {
    environment.messages().forget(kind);
    interrupts.clear();
    cyclic.clear();
    next.clear();
    Arrays.fill(stack, null);
    height = 0;
    calls = 0;
    top = null;
    halted = false;
  }

  void begin(CompiledRoutine routine, List<KrlValue> arguments) throws KrlExecutionException {
    if (arguments.size() > routine.parameters().size()) {
      throw new KrlExecutionException(
          KrlExecutionException.WRONG_TYPE,
          routine.name()
              + " has "
              + routine.parameters().size()
              + " parameters, was given "
              + arguments.size());
    }
    CallFrame frame = new CallFrame(routine, null, false, 0);
    for (int i = 0; i < routine.parameters().size(); i++) {
      bind(frame, i, i < arguments.size() ? arguments.get(i) : null);
    }
    clear();
    top = frame;
    calls = 1;
  }

  boolean ended() {
    return top == null;
  }

  boolean halted() {
    return halted;
  }

  /**
   * Executes instructions until one waits, the program halts or ends, or the limit is reached.
   *
   * @param step where to halt after {@link #beginLine}
   */
  void run(int maxInstructions, LineStep step) throws KrlExecutionException {
    beginCycle();
    cyclic.execute(this);
    interrupts.watch(this);
    interrupt();
    execute(maxInstructions, false, step);
  }

  /** Executes the triggers that have fired, as far as they do not wait. */
  void runTriggers(int maxInstructions) throws KrlExecutionException {
    beginCycle();
    interrupt();
    execute(maxInstructions, true, LineStep.NONE);
  }

  private void beginCycle() {
    waiting = false;
    waitsForCondition = false;
    halted = false;
    faultPosition = null;
    executed = 0;
  }

  private void execute(int maxInstructions, boolean interruptions, LineStep step)
      throws KrlExecutionException {
    while (executed < maxInstructions && !waiting && !halted) {
      CallFrame frame = top;
      if (frame == null || (interruptions && interruption() == null)) {
        break;
      }
      executed++;
      int instruction = frame.next();
      try {
        frame.fetch().execute(this);
      } catch (KrlExecutionException fault) {
        if (!proceed(fault)) {
          recover();
          throw fault;
        }
      }
      if (step != LineStep.NONE
          && isNextLine(frame, instruction)
          && !(step == LineStep.OVER && isCalledInLine())) {
        halted = true;
      }
    }
  }

  /** Continues after a statement that failed and is protected; else returns false. */
  private boolean proceed(KrlExecutionException fault) {
    CallFrame frame = frame();
    if (faultPosition != null || !frame.proceeds()) {
      return false;
    }
    drop(frame.stackBase());
    environment.error(fault.number());
    frame.skip();
    return true;
  }

  /**
   * Raises an error as {@code ERR_RAISE}: in the innermost protected call of the running code, else
   * here (assumed).
   */
  void raise(KrlExecutionException fault) throws KrlExecutionException {
    CallFrame frame = top;
    while (frame != null && !frame.proceeds() && frame.interruption() == null) {
      frame = frame.caller();
    }
    if (frame != null && frame.proceeds()) {
      while (top != null && top != frame) {
        leave(top);
      }
    }
    throw fault;
  }

  /** Marks the line that is executed alone. */
  void beginLine() {
    lineFrame = top;
    lineInstruction = top == null ? 0 : top.next();
  }

  /** Returns whether an instruction was the last of its line. */
  private boolean isNextLine(CallFrame executedIn, int instruction) {
    CallFrame frame = top;
    if (frame == null || (frame == executedIn && frame.next() == instruction)) {
      return false; // the end, or an instruction that waits
    }
    return frame.atStatement()
        && (frame != lineFrame
            || frame.next() == lineInstruction
            || frame.position().line() != frame.position(lineInstruction).line());
  }

  /** Returns whether the line has called the present routine, directly or not. */
  private boolean isCalledInLine() {
    CallFrame frame = top == null ? null : top.caller();
    while (frame != null && frame != lineFrame) {
      frame = frame.caller();
    }
    return frame != null;
  }

  void selectLine(int line) {
    CallFrame frame = top;
    while (frame != null && (frame.interruption() != null || frame.statementAt(line) < 0)) {
      frame = frame.caller();
    }
    if (frame == null) {
      throw new IllegalArgumentException(
          "line " + line + " is in no routine that is being executed");
    }
    while (top != null && top != frame) {
      leave(top);
    }
    drop(frame.stackBase());
    next.clear();
    environment.messages().lineSelected(kind);
    frame.jump(frame.statementAt(line));
  }

  /** Returns the number of instructions that the last {@link #run} has executed. */
  int executed() {
    return executed;
  }

  /** Goes back to the start of the statement that failed. */
  private void recover() {
    next.forgetStatement();
    CallFrame frame = frame();
    if (faultPosition == null) {
      faultPosition = frame.executed();
    }
    frame.statementAgain();
    drop(frame.stackBase());
  }

  private void drop(int base) {
    while (height > base) {
      popArgument();
    }
  }

  /** Returns the position of the fault that {@link #run} has thrown. */
  Position faultPosition() {
    return faultPosition == null ? frame().position() : faultPosition;
  }

  void fire(Interruption trigger) {
    interrupts.add(trigger);
  }

  List<KrlInterpreter.Level> levels() {
    List<KrlInterpreter.Level> levels = new ArrayList<>();
    boolean interrupt = false;
    for (CallFrame frame = top; frame != null; frame = frame.caller()) {
      Position position = frame == top ? frame.position() : frame.executed();
      CallFrame caller = frame.caller();
      boolean action = frame.interruption() != null;
      // the action of an interrupt is shown as the routine it calls
      if (!action || frame == top) {
        interrupt = action || (caller != null && caller.interruption() != null);
        levels.add(
            new KrlInterpreter.Level(
                frame.routine().module(), frame.routine().name(), position, interrupt));
      }
    }
    return levels;
  }

  // for instructions: the stack

  CallFrame frame() {
    CallFrame frame = top;
    if (frame == null) {
      throw new IllegalStateException("no program is being executed");
    }
    return frame;
  }

  Interpreter kind() {
    return kind;
  }

  ProgramEnvironment environment() {
    return environment;
  }

  Interrupts interrupts() {
    return interrupts;
  }

  CyclicAssignments cyclic() {
    return cyclic;
  }

  void push(@Nullable Object value) {
    if (height == stack.length) {
      stack = Arrays.copyOf(stack, 2 * height);
    }
    stack[height++] = value;
  }

  /** Returns the last value on the stack, which stays there; null for an omitted argument. */
  @Nullable Object peek() {
    return stack[height - 1];
  }

  @Nullable Object popArgument() {
    Object value = stack[--height];
    stack[height] = null;
    return value;
  }

  KrlValue pop() {
    return (KrlValue) Objects.requireNonNull(popArgument());
  }

  Reference popReference() {
    return (Reference) Objects.requireNonNull(popArgument());
  }

  boolean popBool() throws KrlExecutionException {
    return Operators.boolOf(pop());
  }

  int popInt() throws KrlExecutionException {
    return Operators.intOf(pop());
  }

  double popNumber() throws KrlExecutionException {
    return Operators.number(pop());
  }

  // for instructions: the flow

  void jump(int target) {
    frame().jump(target);
  }

  /** Ends this cycle because a condition is false. */
  void awaitCondition() {
    waiting = true;
    waitsForCondition = true;
  }

  boolean waitsForCondition() {
    return waitsForCondition;
  }

  /** Ends this cycle; the instruction is executed again in the next. */
  void again() {
    frame().again();
    waiting = true;
  }

  void halt() {
    halted = true;
  }

  /** Calls a routine, whose arguments are on the stack. */
  void call(CompiledRoutine routine, boolean resultWanted) throws KrlExecutionException {
    // an interrupt adds a call without this check
    if (calls >= MAX_CALLS) {
      throw new KrlExecutionException(
          KrlExecutionException.CALL_STACK,
          "calls nest at most " + MAX_CALLS + " deep, " + routine.name() + " is one too many");
    }
    int count = routine.parameters().size();
    CallFrame frame = new CallFrame(routine, frame(), resultWanted, height - count);
    for (int i = count - 1; i >= 0; i--) {
      bind(frame, i, popArgument());
    }
    top = frame;
    calls++;
  }

  private static void bind(CallFrame frame, int slot, @Nullable Object argument)
      throws KrlExecutionException {
    CompiledRoutine.Parameter parameter = frame.routine().parameters().get(slot);
    if (parameter.out()) {
      frame.setReference(
          slot,
          argument instanceof Reference reference
              ? reference
              : new Reference(new StorageLocation.Local(slot), frame, parameter.path()));
    }
    if (argument instanceof Storage contents) {
      frame.setLocal(slot, contents);
    } else if (argument instanceof KrlString text && parameter.array()) {
      frame.setLocal(slot, Storage.ofText(text));
    } else if (argument != null && !(parameter.out() && argument instanceof Reference)) {
      new StorageLocation.Local(slot).write(frame, parameter.path(), (KrlValue) argument);
    }
  }

  /** Ends a function. */
  void returnValue(KrlValue value) throws KrlExecutionException {
    CallFrame frame = frame();
    Storage result = frame.routine().body().result();
    if (result == null) {
      throw new KrlExecutionException(
          KrlExecutionException.NOT_ALLOWED,
          "the type of function " + frame.routine().name() + " is not known");
    }
    KrlValue converted;
    try {
      converted = result.store(result.hasBrackets() ? RESULT_ARRAY : RESULT, value).value();
    } catch (RefusedException e) {
      throw KrlExecutionException.of("the value of " + frame.routine().name(), e);
    }
    leave(frame);
    if (frame.resultWanted()) {
      push(converted);
    }
  }

  /** Ends a subprogram, an action, or the program. */
  void returnNothing() {
    CallFrame frame = frame();
    Interruption interruption = frame.interruption();
    boolean outermost = frame.caller() == null;
    boolean motions = outermost || (interruption != null && interruption.holding());
    if (motions && mustWaitForMotion()) {
      again();
      return;
    }
    leave(frame);
    if (interruption != null) {
      if (interruption.holding()) {
        environment.releaseMotion();
      }
      interrupt();
    }
  }

  private void leave(CallFrame frame) {
    drop(frame.stackBase());
    if (frame.interruption() == null) {
      interrupts.forget(frame);
    }
    top = frame.caller();
    calls--;
  }

  // for instructions: interrupts

  private @Nullable CallFrame interruptingFrame() {
    CallFrame frame = top;
    while (frame != null && frame.interruption() == null) {
      frame = frame.caller();
    }
    return frame;
  }

  private @Nullable Interruption interruption() {
    CallFrame frame = interruptingFrame();
    return frame == null ? null : frame.interruption();
  }

  /** Starts the most urgent interruption that has a higher priority than the running code. */
  private void interrupt() {
    Interruption running = interruption();
    Interruption urgent = interrupts.next(running == null ? LOWEST_PRIORITY : running.priority());
    if (urgent != null) {
      top = new CallFrame(urgent.owner(), urgent.action(), frame(), urgent, height);
      calls++;
    }
  }

  boolean condition(CompiledCode condition, CallFrame owner) throws KrlExecutionException {
    return Operators.boolOf(value(condition, owner));
  }

  /** Returns the value of an expression, whose instructions neither call nor wait. */
  KrlValue value(CompiledCode condition, CallFrame owner) throws KrlExecutionException {
    CallFrame interrupted = frame();
    CallFrame frame = new CallFrame(owner, condition, interrupted, null, height);
    top = frame;
    try {
      for (int i = 0; i < condition.size(); i++) {
        frame.fetch().execute(this);
      }
      return pop();
    } catch (KrlExecutionException fault) {
      faultPosition = frame.executed();
      drop(frame.stackBase());
      throw fault;
    } finally {
      top = interrupted;
    }
  }

  void brake(boolean maximum) throws KrlExecutionException {
    requireRobot("BRAKE");
    Interruption interruption = interruption();
    if (interruption == null) {
      throw new KrlExecutionException(
          KrlExecutionException.NOT_ALLOWED,
          "BRAKE is allowed in the routine of an interrupt only");
    }
    hold(interruption, maximum);
  }

  private void hold(Interruption interruption, boolean maximum) {
    if (!interruption.holding()) {
      interruption.setHolding();
      environment.holdMotion(maximum);
    }
  }

  /**
   * Cancels the routine of an interrupt and the code it has interrupted, down to the routine that
   * declared it. The motions of the routine end before (assumed), so that a robot that returns to
   * {@code $POS_INT} arrives.
   */
  void resume() throws KrlExecutionException {
    requireRobot("RESUME");
    CallFrame action = interruptingFrame();
    Interruption interruption = action == null ? null : action.interruption();
    if (action == null || interruption == null || interruption.isTrigger()) {
      throw new KrlExecutionException(
          KrlExecutionException.NOT_ALLOWED,
          "RESUME is allowed in the routine of an interrupt only");
    }
    CallFrame declaring = interruption.owner();
    CallFrame cancelled = calledBy(declaring);
    // assumed: as on KSS, the cancelled subprogram runs below the level of declaration
    if (cancelled == null || cancelled == action || cancelled.resultWanted()) {
      throw new KrlExecutionException(
          KrlExecutionException.NOT_ALLOWED,
          "RESUME cancels a subprogram called by the routine that has declared the interrupt,"
              + " no such subprogram is running");
    }
    if (interruption.holding() && mustWaitForMotion()) {
      again();
      return;
    }
    int holds = 0;
    while (top != null && top != declaring) {
      Interruption ended = top.interruption();
      holds += ended != null && ended.holding() ? 1 : 0;
      leave(top);
    }
    next.clear();
    environment.discardMotion(holds);
  }

  /**
   * Returns the frame that a frame has called, or that has interrupted it; null if it has ended.
   */
  private @Nullable CallFrame calledBy(CallFrame caller) {
    CallFrame frame = top;
    while (frame != null && frame.caller() != caller) {
      frame = frame.caller();
    }
    return frame;
  }

  // for instructions: the robot

  private void requireRobot(String what) throws KrlExecutionException {
    if (kind == Interpreter.SUBMIT) {
      throw new KrlExecutionException(
          KrlExecutionException.NOT_ALLOWED, what + " is not allowed in the submit interpreter");
    }
  }

  private boolean mustWaitForMotion() {
    return kind == Interpreter.ROBOT && !environment.motionFinished();
  }

  /** Waits until the robot has finished its motions, which stops the advance run. */
  void awaitMotion() {
    Interruption interruption = interruption();
    // the motion of the interrupted program continues during the routine of an interrupt
    boolean own = interruption == null || interruption.holding();
    if (own && mustWaitForMotion()) {
      again();
    }
  }

  /** Waits until the next motion may be planned. */
  void awaitAdvance() throws KrlExecutionException {
    requireRobot("a motion");
    Interruption interruption = interruption();
    if (interruption != null) {
      // assumed: a motion in the routine of an interrupt brakes the robot first
      hold(interruption, false);
    }
    if (!environment.motionFinished() && environment.motionsAhead() >= environment.advance()) {
      again();
    }
  }

  /** Waits for the last motion if no motion may be planned in advance. */
  void awaitMotionWithoutAdvance() {
    if (environment.advance() == 0 && mustWaitForMotion()) {
      again();
    }
  }

  void trigger(TriggerOrder trigger) throws KrlExecutionException {
    requireRobot("TRIGGER");
    next.add(trigger);
  }

  void stop(MotionOrder.Stop stop) throws KrlExecutionException {
    requireRobot("STOP WHEN");
    next.add(stop);
  }

  /** Returns the settings of the next motion. */
  NextMotion next() {
    return next;
  }

  String module() {
    return frame().routine().module();
  }
}
