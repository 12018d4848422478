package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.code.ListFlag;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks for the items of a directory (type 21): {@code types, flags, path}.
 *
 * @param id u16, echoed in the answer
 * @param types i32; the kinds of items that are asked for, or none for all
 * @param flags i32
 * @param path WSTRING; 32,762 characters at most
 */
public record ListDirectoryRequest(
    int id, Flags<ItemType> types, Flags<ListFlag> flags, String path) implements FileRequest {
  /** Checks the ranges. */
  public ListDirectoryRequest {
    Ranges.u16("id", id);
    Ranges.frame("path", 1 + 4 + 4 + Ranges.wide(path));
  }
}
