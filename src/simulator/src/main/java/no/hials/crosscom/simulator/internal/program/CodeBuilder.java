package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;

/** Collects instructions. */
final class CodeBuilder {
  private final List<CompiledCode.Step> steps = new ArrayList<>();
  private int statement;

  /** A jump target, which can be set after the jump. */
  static final class Label {
    private int target = -1;

    int target() {
      return target;
    }
  }

  void statement() {
    statement = steps.size();
  }

  void emit(Position position, Instruction operation) {
    steps.add(new CompiledCode.Step(operation, position, statement));
  }

  /** Returns the number of instructions so far. */
  int size() {
    return steps.size();
  }

  /** Replaces the code of a statement by a fault, which keeps the targets of jumps. */
  void stop(int begin, Position position, int number, String reason) {
    Instruction fault =
        machine -> {
          throw new KrlExecutionException(number, reason);
        };
    if (begin == steps.size()) {
      emit(position, fault);
    } else {
      steps.set(begin, new CompiledCode.Step(fault, position, begin));
    }
  }

  void constant(Position position, KrlValue value) {
    emit(position, machine -> machine.push(value));
  }

  void mark(Label label) {
    label.target = steps.size();
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

  CompiledCode build() {
    return new CompiledCode(List.copyOf(steps));
  }
}
