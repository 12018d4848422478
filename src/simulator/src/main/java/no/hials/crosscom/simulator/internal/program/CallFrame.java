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
  private int next;
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
    return code.steps().get(next++).instruction();
  }

  /** Returns the index of the next instruction. */
  int next() {
    return next;
  }

  /** Returns whether the next instruction is the first of its statement. */
  boolean atStatement() {
    return code.steps().get(next).statement() == next;
  }

  /** Returns the first statement in or after a line; negative if the routine ends before it. */
  int statementAt(int line) {
    List<CompiledCode.Step> steps = code.steps();
    if (line < routine.begin().line() - 1) {
      return -1;
    }
    for (int i = 0; i < steps.size(); i++) {
      if (steps.get(i).statement() == i && steps.get(i).position().line() >= line) {
        return i;
      }
    }
    return -1;
  }

  void jump(int target) {
    next = target;
  }

  /** Goes back to the current instruction. */
  void again() {
    next--;
  }

  /** Goes back to the first instruction of the current statement. */
  void statementAgain() {
    next = code.steps().get(next - 1).statement();
  }

  /** Returns the position of the last executed instruction. */
  Position executed() {
    return code.steps().get(next == 0 ? 0 : next - 1).position();
  }

  /** Returns the position of an instruction. */
  Position position(int instruction) {
    return code.steps().get(instruction).position();
  }

  /** Returns the position of the next instruction. */
  Position position() {
    return code.steps().get(next).position();
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
   * @param statement the index of its first instruction
   * @param next the index of the instruction to continue with after an error
   */
  void proceed(int statement, int next) {
    protectedStatement = statement;
    afterProtected = next;
  }

  /** Returns whether the current statement is protected. */
  boolean proceeds() {
    return next > 0 && code.steps().get(next - 1).statement() == protectedStatement;
  }

  /** Continues after the protected statement. */
  void skip() {
    next = afterProtected;
    protectedStatement = -1;
  }

  long deadline() {
    return deadline;
  }

  void setDeadline(long time) {
    deadline = time;
  }
}
