package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks to store the bytes sent as a file (type 29): {@code 04, flags, name}.
 *
 * @param id u16, echoed in the answer
 * @param flags i32
 * @param name WSTRING; 32,763 characters at most
 */
public record EndWriteRequest(int id, Flags<CopyFlag> flags, String name) implements FileRequest {
  /** Checks the ranges. */
  public EndWriteRequest {
    Ranges.u16("id", id);
    Ranges.frame("name", 1 + 1 + 4 + Ranges.wide(name));
  }
}
