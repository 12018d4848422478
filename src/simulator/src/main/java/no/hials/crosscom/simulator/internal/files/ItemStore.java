package no.hials.crosscom.simulator.internal.files;

import java.io.IOException;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Where the items of a tree are. Names are found in any case. Not thread-safe. What a method needs
 * to be there or not to be there has been checked by its caller.
 */
interface ItemStore {
  /** What an item counts beside its content, so that empty ones are not for nothing. */
  int ITEM_COST = 512;

  /** Finds an item; null if it is not there. */
  @Nullable FileItem find(ControllerPath path) throws IOException;

  /** Lists a folder, sorted by name whatever its case. */
  List<FileItem> children(ControllerPath folder) throws IOException;

  /** Gives a file's content, which nobody changes any more. */
  byte[] read(FileItem file) throws IOException;

  /** Writes a file, in place of one that is there, whose attributes stay. Keeps the array. */
  void write(ControllerPath path, byte[] content) throws IOException;

  void makeFolder(ControllerPath path) throws IOException;

  /** Deletes a file or an empty folder. */
  void delete(FileItem item) throws IOException;

  /** Moves a file or a folder with all that is in it to where nothing is. */
  void move(FileItem item, ControllerPath to) throws IOException;

  /** Sets those attributes that can be set. */
  void setAttributes(FileItem item, int attributes) throws IOException;

  /** How much is stored: all contents, and {@link #ITEM_COST} for each item. */
  long used() throws IOException;
}
