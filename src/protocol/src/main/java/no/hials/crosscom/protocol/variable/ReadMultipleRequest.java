package no.hials.crosscom.protocol.variable;

import java.util.List;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks for the texts of several variables (type 6): {@code count u8, names}.
 *
 * @param id u16, echoed in the answer
 * @param names WSTRING each; 255 at most
 */
public record ReadMultipleRequest(int id, List<String> names) implements VariableRequest {
  /** Checks the ranges. */
  public ReadMultipleRequest {
    names = List.copyOf(names);
    Ranges.u16("id", id);
    Ranges.count("names", names, 255);
    Ranges.frame("names", 1 + 1 + Ranges.wide(names));
  }
}
