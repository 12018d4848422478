package no.hials.crosscom.protocol.variable;

import java.util.List;
import no.hials.crosscom.protocol.Strictness;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Sets several variables from texts (type 7): {@code count u8, assignments}.
 *
 * @param id u16, echoed in the answer
 * @param count u8; the announced number of assignments. If fewer follow, a server does those and
 *     then reports an error (docs/reference/c3-messages.md#framing); only {@link
 *     Strictness#LENIENT} reads such a request
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
   * Creates a request that announces the number of its assignments.
   *
   * @param id 0 to 65535
   * @param assignments 255 at most
   */
  public WriteMultipleRequest(int id, List<Assignment> assignments) {
    this(id, assignments.size(), assignments);
  }
}
