package no.hials.crosscom.simulator.internal.program;

import java.util.List;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.data.Storage;
import org.jspecify.annotations.Nullable;

/** The execution of a routine, or of an action or condition in it. */
final class CallFrame {
  private final CompiledRoutine routine;
  private final CompiledCode code;
  private final @Nullable CallFrame caller;
  private final @Nullable Interruption interruption;
  private final boolean resultWanted;
  private final int stackBase;
  private final Storage[] locals;
  private final @Nullable Reference[] references;
  private final @Nullable KrlValue[] temporaries;

  /** The slot of the next instruction, and its index in there. */
  private int next;

  private int index;

  /** The instructions in the slot; null until they are needed. */
  private @Nullable List<CompiledCode.Step> steps;

  /** The last executed instruction and its place; null before the first. */
  private CompiledCode.@Nullable Step executed;

  private int executedSlot;
  private int executedIndex;
  private long deadline;
  private int protectedStatement = -1;
  private int afterProtected;

  CallFrame(
      CompiledRoutine routine, @Nullable CallFrame caller, boolean resultWanted, int stackBase) {
    this.routine = routine;
    CompiledRoutine.Body body = routine.body();
    this.code = body.code();
    this.caller = caller;
    this.interruption = null;
    this.resultWanted = resultWanted;
    this.stackBase = stackBase;
    this.locals = body.locals().toArray(new Storage[0]);
    this.references = new Reference[routine.parameters().size()];
    this.temporaries = new KrlValue[body.temporaries()];
  }

  /**
   * Creates the frame of an action or a condition of a routine, which uses the variables of the
   * routine.
   */
  CallFrame(
      CallFrame owner,
      CompiledCode code,
      @Nullable CallFrame caller,
      @Nullable Interruption interruption,
      int stackBase) {
    this.routine = owner.routine;
    this.code = code;
    this.caller = caller;
    this.interruption = interruption;
    this.resultWanted = false;
    this.stackBase = stackBase;
    this.locals = owner.locals;
    this.references = owner.references;
    this.temporaries = owner.temporaries;
  }

  CompiledRoutine routine() {
    return routine;
  }

  /** Returns the frame that continues after this one; null for the outermost. */
  @Nullable CallFrame caller() {
    return caller;
  }

  /**
   * Returns the interruption of the calling frame; null if that frame has called this one itself.
   */
  @Nullable Interruption interruption() {
    return interruption;
  }

  /** Returns whether the calling frame needs a value. */
  boolean resultWanted() {
    return resultWanted;
  }

  /** Returns the number of values on the stack that belong to calling frames. */
  int stackBase() {
    return stackBase;
  }

  Instruction fetch() {
    List<CompiledCode.Step> there = steps();
    CompiledCode.Step step = there.get(index);
    executed = step;
    executedSlot = next;
    executedIndex = index;
    if (index + 1 < there.size()) {
      index++;
    } else {
      jump(next + 1);
    }
    return step.instruction();
  }

  private List<CompiledCode.Step> steps() {
    List<CompiledCode.Step> known = steps;
    if (known == null) {
      known = code.steps(next);
      steps = known;
    }
    return known;
  }

  /** Returns the slot of the next instruction. */
  int next() {
    return next;
  }

  /** Returns whether the next instruction is the first of its statement. */
  boolean atStatement() {
    return index == 0 && code.statement(next) == next;
  }

  /** Returns the first statement in or after a line; negative if the routine ends before it. */
  int statementAt(int line) {
    return line < routine.begin().line() - 1 ? -1 : code.statementAt(line);
  }

  void jump(int target) {
    next = target;
    index = 0;
    steps = null;
  }

  /** Goes back to the current instruction. */
  void again() {
    jump(executedSlot);
    index = executedIndex;
  }

  /** Goes back to the first instruction of the current statement. */
  void statementAgain() {
    jump(code.statement(executedSlot));
  }

  /** Returns the position of the last executed instruction. */
  Position executed() {
    return executed == null ? code.position(0) : executed.position();
  }

  /** Returns the position of the first instruction in a slot. */
  Position position(int slot) {
    return code.position(slot);
  }

  /** Returns the position of the next instruction. */
  Position position() {
    return steps().get(index).position();
  }

  Storage local(int slot) {
    return locals[slot];
  }

  void setLocal(int slot, Storage contents) {
    locals[slot] = contents;
  }

  Reference reference(int slot) {
    Reference reference = references[slot];
    if (reference == null) {
      throw new IllegalStateException("parameter " + slot + " is not by reference");
    }
    return reference;
  }

  void setReference(int slot, Reference reference) {
    references[slot] = reference;
  }

  /** Returns a value that a loop or a branch keeps. */
  KrlValue temporary(int slot) throws KrlExecutionException {
    KrlValue value = temporaries[slot];
    if (value == null) {
      throw new KrlExecutionException(
          KrlExecutionException.NOT_ALLOWED,
          "a FOR or SWITCH cannot be continued after the selection of a line in it");
    }
    return value;
  }

  void setTemporary(int slot, KrlValue value) {
    temporaries[slot] = value;
  }

  /**
   * Protects a statement, whose errors do not stop the program.
   *
   * @param statement the slot in which it begins
   * @param next the slot to continue with after an error
   */
  void proceed(int statement, int next) {
    protectedStatement = statement;
    afterProtected = next;
  }

  /** Returns whether the current statement is protected. */
  boolean proceeds() {
    return executed != null && code.statement(executedSlot) == protectedStatement;
  }

  /** Continues after the protected statement. */
  void skip() {
    jump(afterProtected);
    protectedStatement = -1;
  }

  long deadline() {
    return deadline;
  }

  void setDeadline(long time) {
    deadline = time;
  }
}
