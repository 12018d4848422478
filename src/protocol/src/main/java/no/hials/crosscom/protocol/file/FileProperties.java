package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.EditMode;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;

/**
 * The properties of a file (type 26). Properties that the request did not ask for are 0 or empty.
 *
 * @param itemType i32
 * @param size i32 low and i32 high half; in bytes, 0 or more
 * @param attributes i32
 * @param created i32 low, i32 high, i32 bias
 * @param accessed as {@code created}
 * @param modified as {@code created}
 * @param editMode i32
 * @param name WSTRING: u16 count of characters and UTF-16, little-endian
 */
public record FileProperties(
    Code<ItemType> itemType,
    long size,
    Flags<FileAttribute> attributes,
    ItemTime created,
    ItemTime accessed,
    ItemTime modified,
    Code<EditMode> editMode,
    String name) {
  /** The length of all properties but the name. */
  static final int FIXED_LENGTH = 4 + 8 + 4 + 3 * 12 + 4;

  /** All 0 and empty, as in the answer for a file that does not exist. */
  public static final FileProperties NONE =
      new FileProperties(
          Code.of(ItemType.UNKNOWN),
          0,
          Flags.none(FileAttribute.class),
          ItemTime.NONE,
          ItemTime.NONE,
          ItemTime.NONE,
          Code.of(EditMode.FULL),
          "");

  /** Checks the range. */
  public FileProperties {
    if (size < 0) {
      throw new IllegalArgumentException("size must not be negative, is " + size);
    }
  }
}
