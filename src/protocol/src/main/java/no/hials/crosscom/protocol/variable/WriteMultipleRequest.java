package no.hials.crosscom.protocol.variable;

import java.util.List;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Strictness;
import no.hials.crosscom.protocol.internal.Ranges;

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
    implements VariableRequest {
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

  @Override
  public MessageType type() {
    return MessageType.WRITE_MULTIPLE;
  }
}
