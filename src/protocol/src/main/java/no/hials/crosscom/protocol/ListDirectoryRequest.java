package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.code.ListFlag;

/**
 * Asks for the items of a directory (c3-bridge.md, type 21): {@code types, flags, path}.
 *
 * @param id u16, echoed in the answer
 * @param types i32; the kinds of items that are asked for, none for all (c3-vectors.tsv)
 * @param flags i32
 * @param path WSTRING; 32,762 characters at most
 */
public record ListDirectoryRequest(
    int id, Flags<ItemType> types, Flags<ListFlag> flags, String path) implements Request {
  static final Layout<ListDirectoryRequest> LAYOUT =
      new Layout<>(
          (m, out) -> {
            out.i32(m.types.bits());
            out.i32(m.flags.bits());
            out.putWide(m.path);
          },
          (id, in, tail) ->
              new ListDirectoryRequest(
                  id,
                  new Flags<>(ItemType.class, in.i32("types")),
                  new Flags<>(ListFlag.class, in.i32("flags")),
                  in.wide("path")));

  /** Checks the ranges. */
  public ListDirectoryRequest {
    Ranges.u16("id", id);
    Ranges.frame("path", 1 + 4 + 4 + Ranges.wide(path));
  }

  @Override
  public MessageType type() {
    return MessageType.LIST_DIRECTORY;
  }
}
