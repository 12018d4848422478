package no.hials.crosscom.protocol;

/**
 * Answers {@link BenchmarkReadRequest} and {@link BenchmarkWriteRequest} (c3-bridge.md, type 17):
 * {@code write, count, iterations, start, stop, difference}.
 *
 * @param id u16, of the request
 * @param write u8, 0 or 1, of the request
 * @param count u8, of the request
 * @param iterations u32, of the request
 * @param startMillis u32, in ms
 * @param stopMillis u32, in ms
 * @param differenceMillis u32, in ms
 * @param tail how the access ended
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
  static final Layout<BenchmarkResponse> LAYOUT =
      new Layout<>(
          (m, out) -> {
            out.bool(m.write);
            out.u8(m.count);
            out.u32(m.iterations);
            out.u32(m.startMillis);
            out.u32(m.stopMillis);
            out.u32(m.differenceMillis);
          },
          (id, in, tail) ->
              new BenchmarkResponse(
                  id,
                  in.bool("write"),
                  in.u8("count"),
                  in.u32("iterations"),
                  in.u32("start"),
                  in.u32("stop"),
                  in.u32("difference"),
                  tail));

  /** Checks the ranges. */
  public BenchmarkResponse {
    Ranges.u16("id", id);
    Ranges.u8("count", count);
    Ranges.u32("iterations", iterations);
    Ranges.u32("start", startMillis);
    Ranges.u32("stop", stopMillis);
    Ranges.u32("difference", differenceMillis);
  }

  @Override
  public MessageType type() {
    return MessageType.BENCHMARK;
  }
}
