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
 * @param name the name as the server lists it; a whole path if the list flags made it so
 * @param type what it is, known or not; nothing if the server did not say
 * @param attributes what it is marked with; nothing if the server did not say
 * @param size in bytes; nothing if the server did not say
 * @param info what the server said of it, as it is; empty if nothing
 */
public record FileEntry(
    String name,
    Optional<Code<ItemType>> type,
    Optional<Flags<FileAttribute>> attributes,
    OptionalLong size,
    String info) {

  /**
   * Says whether it is known to be a directory, real or virtual.
   *
   * @return true if so; false if the server did not say
   */
  public boolean isDirectory() {
    return type.filter(FileInfo::isDirectory).isPresent();
  }
}
