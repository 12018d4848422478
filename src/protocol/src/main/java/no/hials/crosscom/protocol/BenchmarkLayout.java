package no.hials.crosscom.protocol;

import java.util.ArrayList;
import java.util.List;

/** The two layouts of type 17. */
final class BenchmarkLayout {
  static final Layout<Request> REQUEST =
      new Layout<>(BenchmarkLayout::write, BenchmarkLayout::read);

  private BenchmarkLayout() {}

  private static void write(Request request, WireBuffer out) {
    if (request instanceof BenchmarkReadRequest read) {
      out.bool(false);
      out.u8(read.names().size());
      out.u32(read.iterations());
      read.names().forEach(out::putWide);
    } else if (request instanceof BenchmarkWriteRequest write) {
      out.bool(true);
      out.u8(write.assignments().size());
      out.u32(write.iterations());
      write.assignments().forEach(assignment -> assignment.write(out));
    }
  }

  private static Request read(int id, WireBuffer in, Tail tail) throws MalformedFrameException {
    boolean write = in.bool("write");
    int count = in.u8("count");
    long iterations = in.u32("iterations");
    if (!write) {
      return new BenchmarkReadRequest(id, iterations, in.wides(count, "name"));
    }
    List<Assignment> assignments = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      assignments.add(Assignment.read(in));
    }
    return new BenchmarkWriteRequest(id, iterations, assignments);
  }
}
