package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.value.KrlValue;

/** Collects instructions. */
final class CodeBuilder {
  private final List<Instruction> operations = new ArrayList<>();
  private final List<Position> positions = new ArrayList<>();
  private final List<Integer> statements = new ArrayList<>();
  private int statement;

  /** A jump target, which can be set after the jump. */
  static final class Label {
    private int target = -1;
  }

  /** Starts a statement. */
  void statement() {
    statement = operations.size();
  }

  void emit(Position position, Instruction operation) {
    operations.add(operation);
    positions.add(position);
    statements.add(statement);
  }

  void constant(Position position, KrlValue value) {
    emit(position, machine -> machine.push(value));
  }

  void mark(Label label) {
    label.target = operations.size();
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
    return new CompiledCode(
        operations.toArray(new Instruction[0]),
        positions.toArray(new Position[0]),
        statements.stream().mapToInt(Integer::intValue).toArray());
  }
}
