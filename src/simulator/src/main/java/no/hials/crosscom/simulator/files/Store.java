package no.hials.crosscom.simulator.files;

import java.io.IOException;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Where the items of a tree are. Names are found in any case. Not thread-safe. What a method needs
 * to be there or not to be there has been checked by its caller.
 */
interface Store {
  /** What an item counts beside its content, so that empty ones are not for nothing. */
  int ITEM_COST = 512;

  /** Finds an item; null if it is not there. */
  @Nullable Item find(TreePath path) throws IOException;

  /** Lists a folder, sorted by name whatever its case. */
  List<Item> children(TreePath folder) throws IOException;

  /** Gives a file's content, which nobody changes any more. */
  byte[] read(Item file) throws IOException;

  /** Writes a file, in place of one that is there, whose attributes stay. Keeps the array. */
  void write(TreePath path, byte[] content) throws IOException;

  void makeFolder(TreePath path) throws IOException;

  /** Deletes a file or an empty folder. */
  void delete(Item item) throws IOException;

  /** Moves a file or a folder with all that is in it to where nothing is. */
  void move(Item item, TreePath to) throws IOException;

  /** Sets those attributes that can be set. */
  void setAttributes(Item item, int attributes) throws IOException;

  /** How much is stored: all contents, and {@link #ITEM_COST} for each item. */
  long used() throws IOException;
}
