package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks to read a file in parts (type 30): {@code 01, flags, name}. The length of the name is a u16,
 * as the server reads it; its description has a u32
 * (docs/reference/c3-messages.md#file-content-29-and-30).
 *
 * @param id u16, echoed in the answer
 * @param flags i32
 * @param name WSTRING; 32,763 characters at most
 */
public record BeginReadRequest(int id, Flags<CopyFlag> flags, String name) implements FileRequest {
  /** Checks the ranges. */
  public BeginReadRequest {
    Ranges.u16("id", id);
    Ranges.frame("name", 1 + 1 + 4 + Ranges.wide(name));
  }
}
