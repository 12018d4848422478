package no.hials.crosscom.protocol.variable;

import java.util.List;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks to measure how long reading takes (type 17): {@code 00, count u8, iterations, names}.
 *
 * @param id u16, echoed in the answer
 * @param iterations u32
 * @param names WSTRING each; 255 at most, of which the server uses 10
 */
public record BenchmarkReadRequest(int id, long iterations, List<String> names)
    implements VariableRequest {
  /** Checks the ranges. */
  public BenchmarkReadRequest {
    names = List.copyOf(names);
    Ranges.u16("id", id);
    Ranges.u32("iterations", iterations);
    Ranges.count("names", names, 255);
    Ranges.frame("names", 1 + 1 + 1 + 4 + Ranges.wide(names));
  }
}
