package no.hials.crosscom.protocol.variable;

import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers {@link BenchmarkReadRequest} and {@link BenchmarkWriteRequest} (type 17): {@code write,
 * count, iterations, start, stop, difference}.
 *
 * @param id u16, of the request
 * @param write u8, 0 or 1, of the request
 * @param count u8, of the request
 * @param iterations u32, of the request
 * @param startMillis u32, in ms
 * @param stopMillis u32, in ms
 * @param differenceMillis u32, in ms
 * @param tail the end of the answer
 */
public record BenchmarkResponse(
    int id,
    boolean write,
    int count,
    long iterations,
    long startMillis,
    long stopMillis,
    long differenceMillis,
    Tail tail)
    implements TypedResponse {
  /** Checks the ranges. */
  public BenchmarkResponse {
    Ranges.u16("id", id);
    Ranges.u8("count", count);
    Ranges.u32("iterations", iterations);
    Ranges.u32("start", startMillis);
    Ranges.u32("stop", stopMillis);
    Ranges.u32("difference", differenceMillis);
  }
}
