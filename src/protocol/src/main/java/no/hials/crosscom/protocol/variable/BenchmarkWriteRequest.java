package no.hials.crosscom.protocol.variable;

import java.util.List;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks to measure how long writing takes (type 17): {@code 01, count u8, iterations, assignments}.
 *
 * @param id u16, echoed in the answer
 * @param iterations u32
 * @param assignments WSTRING name and WSTRING value each; 255 at most, of which the server uses 10
 */
public record BenchmarkWriteRequest(int id, long iterations, List<Assignment> assignments)
    implements VariableRequest {
  /** Checks the ranges. */
  public BenchmarkWriteRequest {
    assignments = List.copyOf(assignments);
    Ranges.u16("id", id);
    Ranges.u32("iterations", iterations);
    Ranges.count("assignments", assignments, 255);
    Ranges.frame("assignments", 1 + 1 + 1 + 4 + Assignment.length(assignments));
  }
}
