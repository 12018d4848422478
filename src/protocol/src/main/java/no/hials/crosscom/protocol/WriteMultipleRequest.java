package no.hials.crosscom.protocol;

import java.util.ArrayList;
import java.util.List;

/**
 * Sets several variables from texts (c3-bridge.md, type 7): {@code count u8, assignments}.
 *
 * @param id u16, echoed in the answer
 * @param count u8; how many assignments are announced. More than there are is an error of the
 *     client, after which a server still does those that are there (c3-bridge.md, "Common to all
 *     messages"); only {@link Strictness#LENIENT} reads such a request
 * @param assignments WSTRING name and WSTRING value each; 255 at most
 */
public record WriteMultipleRequest(int id, int count, List<Assignment> assignments)
    implements Request {
  static final Layout<WriteMultipleRequest> LAYOUT =
      new Layout<>(
          (m, out) -> {
            out.u8(m.count);
            m.assignments.forEach(assignment -> assignment.write(out));
          },
          (id, in, tail) -> {
            int count = in.u8("count");
            return new WriteMultipleRequest(id, count, assignments(count, in));
          });

  /** Checks the ranges. */
  public WriteMultipleRequest {
    assignments = List.copyOf(assignments);
    Ranges.u16("id", id);
    Ranges.count("assignments", assignments, 255);
    Ranges.u8("count", count);
    Ranges.count("assignments", assignments, count);
    Ranges.frame("assignments", 1 + 1 + Assignment.length(assignments));
  }

  /**
   * Makes a request that announces what it has.
   *
   * @param id 0 to 65535
   * @param assignments 255 at most
   */
  public WriteMultipleRequest(int id, List<Assignment> assignments) {
    this(id, assignments.size(), assignments);
  }

  private static List<Assignment> assignments(int count, WireBuffer in)
      throws MalformedFrameException {
    List<Assignment> assignments = new ArrayList<>();
    try {
      while (assignments.size() < count) {
        assignments.add(Assignment.read(in));
      }
    } catch (MalformedFrameException e) {
      if (!in.isLenient()) {
        throw e;
      }
    }
    return assignments;
  }

  @Override
  public MessageType type() {
    return MessageType.WRITE_MULTIPLE;
  }
}
