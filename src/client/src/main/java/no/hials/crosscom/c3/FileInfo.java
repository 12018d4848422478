package no.hials.crosscom.c3;

import java.time.Instant;
import java.util.Optional;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.EditMode;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;

/**
 * The properties of a file or directory on the controller.
 *
 * @param name the name, without the directory
 * @param type its type, known or not
 * @param size in bytes, 0 or more
 * @param attributes its attributes; {@link Flags#known} returns the set of the known ones
 * @param created when it was created; empty if the controller does not know
 * @param accessed when it was last used; empty if the controller does not know
 * @param modified when it was last changed; empty if the controller does not know
 * @param editMode how it may be edited on the controller, known or not
 */
public record FileInfo(
    String name,
    Code<ItemType> type,
    long size,
    Flags<FileAttribute> attributes,
    Optional<Instant> created,
    Optional<Instant> accessed,
    Optional<Instant> modified,
    Code<EditMode> editMode) {

  static boolean isDirectory(Code<ItemType> type) {
    return type.is(ItemType.DIRECTORY) || type.is(ItemType.VIRTUAL_DIRECTORY);
  }

  /** Returns whether it is a directory, real or virtual. */
  public boolean isDirectory() {
    return isDirectory(type);
  }
}
