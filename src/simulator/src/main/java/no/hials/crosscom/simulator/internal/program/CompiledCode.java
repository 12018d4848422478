package no.hials.crosscom.simulator.internal.program;

import java.util.List;
import java.util.function.IntFunction;
import no.hials.crosscom.lang.Position;
import org.jspecify.annotations.Nullable;

/**
 * The instructions of a routine, or of a condition or an action in it. A statement without jumps
 * takes one slot and is compiled when the program reaches it, because the instructions of a program
 * with the points of a CAM system take more than twenty times the memory of its file.
 */
final class CompiledCode {
  /** The number of statements that stay compiled, such as those of a loop; a power of 2. */
  private static final int KEPT = 256;

  private final List<Slot> slots;

  /** The statements that were compiled last, by the last bits of their slots. */
  private @Nullable Compiled[] kept = {};

  /** An instruction, or a statement that is compiled when it is reached. */
  sealed interface Slot {}

  /**
   * An instruction.
   *
   * @param position its position in the source
   * @param statement the slot in which its statement begins
   */
  record Step(Instruction instruction, Position position, int statement) implements Slot {}

  /**
   * Successive statements, each of which has a slot.
   *
   * @param compiler compiles the statement of a slot to one or more instructions
   */
  record Statements(IntFunction<List<Step>> compiler) implements Slot {}

  private record Compiled(int slot, List<Step> steps) {}

  /**
   * @param slots the last one never continues to the next
   */
  CompiledCode(List<Slot> slots) {
    this.slots = List.copyOf(slots);
  }

  int size() {
    return slots.size();
  }

  /** Returns the instructions of a statement that is compiled when it is reached, or just one. */
  List<Step> steps(int slot) {
    return slots.get(slot) instanceof Statements statements
        ? compiled(slot, statements)
        : List.of((Step) slots.get(slot));
  }

  private List<Step> compiled(int slot, Statements statements) {
    if (kept.length == 0) {
      kept = new Compiled[KEPT];
    }
    Compiled known = kept[slot & (KEPT - 1)];
    if (known == null || known.slot() != slot) {
      known = new Compiled(slot, statements.compiler().apply(slot));
      kept[slot & (KEPT - 1)] = known;
    }
    return known.steps();
  }

  /** Returns the position of the first instruction in a slot. */
  Position position(int slot) {
    return steps(slot).get(0).position();
  }

  /** Returns the slot in which the statement of a slot begins. */
  int statement(int slot) {
    return slots.get(slot) instanceof Step step ? step.statement() : slot;
  }

  /**
   * Returns the slot of the first statement in or after a line, or of the block that the line is
   * in; negative without one.
   */
  int statementAt(int line) {
    for (int slot = 0; slot < slots.size(); slot++) {
      // the lines of successive statements ascend
      int first = slot;
      int last = slot;
      while (last + 1 < slots.size() && slots.get(last + 1) == slots.get(slot)) {
        last++;
      }
      while (slot < last) {
        int middle = (slot + last) >>> 1;
        if (position(middle).line() >= line) {
          last = middle;
        } else {
          slot = middle + 1;
        }
      }
      if (slot > first && spans(slot - 1, line)) {
        return slot - 1;
      }
      if (spans(slot, line) || (statement(slot) == slot && position(slot).line() >= line)) {
        return slot;
      }
    }
    return -1;
  }

  /** Returns whether a line is one of a statement in several lines, such as a spline block. */
  private boolean spans(int slot, int line) {
    return slots.get(slot) instanceof Statements
        && position(slot).line() < line
        && steps(slot).stream().anyMatch(step -> step.position().line() >= line);
  }
}
