package no.hials.crosscom.simulator.internal.program;

import no.hials.crosscom.lang.Position;

/** The instructions of a routine, or of a condition or an action in it. */
final class CompiledCode {
  private final Instruction[] operations;
  private final Position[] positions;
  private final int[] statements;

  /**
   * @param operations the instructions; the last one never continues to the next
   * @param positions the position of each instruction in the source
   * @param statements for each instruction, the first instruction of its statement
   */
  CompiledCode(Instruction[] operations, Position[] positions, int[] statements) {
    this.operations = operations;
    this.positions = positions;
    this.statements = statements;
  }

  int length() {
    return operations.length;
  }

  Instruction operation(int at) {
    return operations[at];
  }

  Position position(int at) {
    return positions[at];
  }

  /** Returns the first instruction of the statement of an instruction. */
  int statement(int at) {
    return statements[at];
  }
}
