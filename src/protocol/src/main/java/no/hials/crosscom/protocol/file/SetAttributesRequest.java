package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks to change a file's attributes (type 20): {@code attributes, mask, name}.
 *
 * @param id u16, echoed in the answer
 * @param attributes i32; the new values of the attributes in {@code mask}
 * @param mask i32; the attributes to change
 * @param name WSTRING; 32,762 characters at most
 */
public record SetAttributesRequest(
    int id, Flags<FileAttribute> attributes, Flags<FileAttribute> mask, String name)
    implements FileRequest {
  /** Checks the ranges. */
  public SetAttributesRequest {
    Ranges.u16("id", id);
    Ranges.frame("name", 1 + 4 + 4 + Ranges.wide(name));
  }
}
