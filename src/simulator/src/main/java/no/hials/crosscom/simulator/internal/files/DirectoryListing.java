package no.hials.crosscom.simulator.internal.files;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.code.ListFlag;

/** A list of items that fits into an answer (docs/reference/c3-messages.md#error-codes). */
final class DirectoryListing {
  /** The bytes of a u16 length, less type, two counts and footer. */
  private static final int ROOM = 0xFFFF - 1 - 2 * 2 - 3;

  private final int types;
  private final boolean infos;

  /**
   * Measured with all flags set only: the names are full names
   * (docs/reference/c3-messages.md#files-20-to-28). Assumed: both flags ask for them, because plain
   * names would not tell where a file is.
   */
  private final boolean fullNames;

  private final List<FileItem> items = new ArrayList<>();
  private int length;

  DirectoryListing(Flags<ItemType> types, Flags<ListFlag> flags) {
    this.types = types.bits();
    this.infos = infos(flags);
    this.fullNames = flags.has(ListFlag.RECURSIVE) || flags.has(ListFlag.EXPAND);
  }

  /** Returns whether items have an info; the old flag is assumed to mean the same. */
  private static boolean infos(Flags<ListFlag> flags) {
    return flags.has(ListFlag.LONG) || flags.has(ListFlag.OLD_LONG);
  }

  void add(FileItem item) throws FileRefusedException {
    // no types means all types (docs/reference/c3-messages.md#files-20-to-28)
    if (types != 0 && (types & item.type().code()) == 0) {
      return;
    }
    length += 2 + 2 * name(item).length() + (infos ? 2 + 2 * item.info().length() : 0);
    if (length > ROOM) {
      throw new FileRefusedException(
          ErrorCode.LONG_ANSWER, "the list does not fit into one message");
    }
    items.add(item);
  }

  private String name(FileItem item) {
    return fullNames ? item.path().fullName() : item.path().name();
  }

  List<String> names() {
    return items.stream().map(this::name).toList();
  }

  List<String> infos() {
    return infos ? items.stream().map(FileItem::info).toList() : List.of();
  }
}
