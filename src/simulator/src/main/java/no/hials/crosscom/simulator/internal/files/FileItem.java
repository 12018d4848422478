package no.hials.crosscom.simulator.internal.files;

import java.time.Instant;
import java.util.Locale;
import java.util.Map;
import no.hials.crosscom.protocol.code.EditMode;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.ItemType;

/**
 * A file or folder that is there.
 *
 * @param path where, in its own spelling
 * @param directory whether it is a folder
 * @param size in bytes, 0 for a folder
 * @param attributes the bits of {@link FileAttribute}
 * @param created when it was made
 * @param accessed when it was last read
 * @param modified when its content was last written
 */
public record FileItem(
    ControllerPath path,
    boolean directory,
    long size,
    int attributes,
    Instant created,
    Instant accessed,
    Instant modified) {

  /**
   * By the end of the name. That of modules, texts and others is measured (c3-vectors.tsv, type
   * 21); the rest is assumed.
   */
  private static final Map<String, ItemType> TYPES =
      Map.ofEntries(
          Map.entry("src", ItemType.MODULE),
          Map.entry("dat", ItemType.MODULE),
          Map.entry("sub", ItemType.MODULE),
          Map.entry("txt", ItemType.TEXT),
          Map.entry("log", ItemType.TEXT),
          Map.entry("ini", ItemType.TEXT),
          Map.entry("xml", ItemType.TEXT),
          Map.entry("csv", ItemType.TEXT),
          Map.entry("zip", ItemType.ARCHIVE));

  /**
   * Gives the kind of item.
   *
   * @return a folder, or what the end of the name says; {@link ItemType#BINARY} if that is unknown
   */
  public ItemType type() {
    return directory
        ? ItemType.DIRECTORY
        : TYPES.getOrDefault(extension(path.name()), ItemType.BINARY);
  }

  /**
   * Gives who may edit it (c3-vectors.tsv, type 26).
   *
   * @return unknown for a folder, read only if it is marked so, else full
   */
  public EditMode editMode() {
    if (directory) {
      return EditMode.UNKNOWN;
    }
    return readOnly() ? EditMode.READ_ONLY : EditMode.FULL;
  }

  boolean readOnly() {
    return (attributes & FileAttribute.READ_ONLY.code()) != 0;
  }

  /** What stands in a long list: type, attributes and size, as c3-vectors.tsv, type 21, shows. */
  String info() {
    return type().code() + "," + attributes + "," + size;
  }

  /** The end of a name behind its last dot, in lower case; empty if it has none. */
  static String extension(String name) {
    return name.substring(base(name).length()).replace(".", "").toLowerCase(Locale.ROOT);
  }

  /** A name without its last dot and what follows. */
  static String base(String name) {
    int dot = name.lastIndexOf('.');
    return dot < 0 ? name : name.substring(0, dot);
  }

  /** Whether the end of a name is that of a program or a data list. */
  static boolean isModule(String name) {
    return TYPES.get(extension(name)) == ItemType.MODULE;
  }
}
