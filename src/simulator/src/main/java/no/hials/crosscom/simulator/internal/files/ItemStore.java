package no.hials.crosscom.simulator.internal.files;

import java.io.IOException;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Stores the items of a file tree. Names are found in any case. Not thread-safe. Callers have
 * checked that the items a method needs exist, and that the new ones do not.
 */
interface ItemStore {
  /** The bytes that an item counts in addition to its content, so that empty items have a cost. */
  int ITEM_COST = 512;

  /** Returns an item; null if it does not exist. */
  @Nullable FileItem find(ControllerPath path) throws IOException;

  /** Lists a folder, sorted by name, ignoring case. */
  List<FileItem> children(ControllerPath folder) throws IOException;

  /** Returns the content of a file, which must not be changed. */
  byte[] read(FileItem file) throws IOException;

  /** Writes a file. An existing file keeps its attributes. The store keeps the array. */
  void write(ControllerPath path, byte[] content) throws IOException;

  void makeFolder(ControllerPath path) throws IOException;

  /** Deletes a file or an empty folder. */
  void delete(FileItem item) throws IOException;

  /** Moves a file or a folder with its content to a free path. */
  void move(FileItem item, ControllerPath to) throws IOException;

  /** Sets all attributes. */
  void setAttributes(FileItem item, int attributes) throws IOException;

  /** Returns the bytes in use: all contents, and {@link #ITEM_COST} for each item. */
  long used() throws IOException;
}
