package no.hials.crosscom.c3;

import java.util.Optional;
import java.util.OptionalLong;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;

/**
 * One item of a listed directory.
 *
 * @param name the name as the server lists it; a whole path with some list flags
 * @param type its type, known or not; empty if the server did not send it
 * @param attributes its attributes; empty if the server did not send them
 * @param size in bytes; empty if the server did not send it
 * @param info the text that the server sent about it; empty if none
 */
public record FileEntry(
    String name,
    Optional<Code<ItemType>> type,
    Optional<Flags<FileAttribute>> attributes,
    OptionalLong size,
    String info) {

  /**
   * Returns whether it is known to be a directory, real or virtual; false if the server did not
   * send the type.
   */
  public boolean isDirectory() {
    return type.filter(FileInfo::isDirectory).isPresent();
  }
}
