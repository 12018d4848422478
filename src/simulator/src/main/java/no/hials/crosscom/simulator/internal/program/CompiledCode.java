package no.hials.crosscom.simulator.internal.program;

import java.util.List;
import no.hials.crosscom.lang.Position;

/**
 * The instructions of a routine, or of a condition or an action in it.
 *
 * @param steps the last one never continues to the next
 */
record CompiledCode(List<Step> steps) {
  /**
   * An instruction.
   *
   * @param position its position in the source
   * @param statement the index of the first instruction of its statement
   */
  record Step(Instruction instruction, Position position, int statement) {}
}
