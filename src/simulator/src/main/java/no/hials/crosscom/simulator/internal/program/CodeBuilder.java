package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;

/** Collects instructions. */
final class CodeBuilder {
  private final List<CompiledCode.Slot> slots = new ArrayList<>();
  private int statement;

  /** A jump target, which can be set after the jump. */
  static final class Label {
    private int target = -1;

    int target() {
      return target;
    }
  }

  void statement() {
    statement = slots.size();
  }

  void emit(Position position, Instruction operation) {
    slots.add(new CompiledCode.Step(operation, position, statement));
  }

  /** Adds a statement that is compiled when it is reached. */
  void emit(CompiledCode.Statements statements) {
    slots.add(statements);
  }

  /** Returns the number of slots so far. */
  int size() {
    return slots.size();
  }

  /** Replaces the code of a statement by a fault, which keeps the targets of jumps. */
  void stop(int begin, Position position, int number, String reason) {
    Instruction fault =
        machine -> {
          throw new KrlExecutionException(number, reason);
        };
    if (begin == slots.size()) {
      emit(position, fault);
    } else {
      slots.set(begin, new CompiledCode.Step(fault, position, begin));
    }
  }

  void constant(Position position, KrlValue value) {
    emit(position, machine -> machine.push(value));
  }

  void mark(Label label) {
    label.target = slots.size();
  }

  void jump(Position position, Label label) {
    emit(position, machine -> machine.jump(label.target));
  }

  /** Jumps if the BOOL on the stack is TRUE. */
  void jumpIf(Position position, Label label) {
    emit(
        position,
        machine -> {
          if (machine.popBool()) {
            machine.jump(label.target);
          }
        });
  }

  /** Jumps if the BOOL on the stack is FALSE. */
  void jumpUnless(Position position, Label label) {
    emit(
        position,
        machine -> {
          if (!machine.popBool()) {
            machine.jump(label.target);
          }
        });
  }

  /** Returns the instructions, if no statement is left to compile. */
  List<CompiledCode.Step> steps() {
    return slots.stream().map(CompiledCode.Step.class::cast).toList();
  }

  CompiledCode build() {
    return new CompiledCode(slots);
  }
}
