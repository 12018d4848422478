package no.hials.crosscom.simulator.internal.files;

import java.time.Instant;
import java.util.Locale;
import java.util.Map;
import no.hials.crosscom.protocol.code.EditMode;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.ItemType;

/**
 * A file or folder that exists.
 *
 * @param path its path, spelled as stored
 * @param directory whether it is a folder
 * @param size in bytes, 0 for a folder
 * @param attributes the bits of {@link FileAttribute}
 * @param created the time of its creation
 * @param accessed the time of the last read
 * @param modified the time of the last write of its content
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
   * The types by extension. Those of modules, texts and unknown files are measured
   * (docs/reference/c3-messages.md#files-20-to-28), the rest assumed.
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
   * Returns the type: a folder, or by its extension; {@link ItemType#BINARY} if that is unknown.
   */
  public ItemType type() {
    return directory
        ? ItemType.DIRECTORY
        : TYPES.getOrDefault(extension(path.name()), ItemType.BINARY);
  }

  /** Returns who may edit the item (docs/reference/c3-messages.md#files-20-to-28). */
  public EditMode editMode() {
    if (directory) {
      return EditMode.UNKNOWN;
    }
    return readOnly() ? EditMode.READ_ONLY : EditMode.FULL;
  }

  boolean readOnly() {
    return (attributes & FileAttribute.READ_ONLY.code()) != 0;
  }

  /**
   * Returns type, attributes and size, as in a long list
   * (docs/reference/c3-messages.md#files-20-to-28).
   */
  String info() {
    return type().code() + "," + attributes + "," + size;
  }

  /** Returns the part of a name after its last dot, in lower case; empty without a dot. */
  static String extension(String name) {
    return name.substring(base(name).length()).replace(".", "").toLowerCase(Locale.ROOT);
  }

  /** Returns a name without its last dot and the part after it. */
  static String base(String name) {
    int dot = name.lastIndexOf('.');
    return dot < 0 ? name : name.substring(0, dot);
  }

  /** Returns whether the extension is that of a program or a data list. */
  static boolean isModule(String name) {
    return TYPES.get(extension(name)) == ItemType.MODULE;
  }
}
