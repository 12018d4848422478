package no.hials.crosscom.simulator.internal.files;

import java.io.IOException;
import java.util.function.Predicate;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.Flags;
import org.jspecify.annotations.Nullable;

/**
 * Writes files within the capacity, and refuses to overwrite those that must stay. Not thread-safe.
 */
final class CheckedWriter {
  private final ItemStore store;
  private final FileNameResolver names;
  private final long capacity;

  CheckedWriter(ItemStore store, FileNameResolver names, long capacity) {
    this.store = store;
    this.names = names;
    this.capacity = capacity;
  }

  void makeFolders(ControllerPath folder) throws IOException {
    FileItem item = store.find(folder);
    if (item == null) {
      makeFolders(folder.parent());
      makeFolder(folder);
    } else if (!item.directory()) {
      throw FileRefusedException.access(folder, "is not a folder");
    }
  }

  void makeFolder(ControllerPath folder) throws IOException {
    ControllerPath stored = names.asStored(folder);
    reserve(ItemStore.ITEM_COST, folder);
    store.makeFolder(stored);
  }

  /** Writes a file in place of the old item, if there is one. */
  void write(ControllerPath path, byte[] content, @Nullable FileItem old) throws IOException {
    if (old == null) {
      reserve(content.length + (long) ItemStore.ITEM_COST, path);
      store.write(names.asStored(path), content);
    } else {
      reserve(content.length - old.size(), path);
      store.write(old.path(), content);
    }
  }

  void reserve(long bytes, ControllerPath path) throws IOException {
    if (bytes > 0 && bytes > capacity - store.used()) {
      throw tooLarge(path, capacity);
    }
  }

  static FileRefusedException tooLarge(ControllerPath path, long limit) {
    return new FileRefusedException(
        ErrorCode.MEMORY, path + " does not fit, the limit is " + limit + " bytes in all");
  }

  /** Checks the file that a copy would overwrite, and returns it; null if the path is free. */
  @Nullable FileItem overwritten(
      ControllerPath path, Flags<CopyFlag> flags, Predicate<String> inUse) throws IOException {
    FileItem old = store.find(path);
    if (old != null) {
      refuseFolder(path, old);
      if (!flags.has(CopyFlag.OVERWRITE)) {
        throw FileRefusedException.access(path, "already exists");
      }
      if (old.readOnly() && !flags.has(CopyFlag.OVERWRITE_READ_ONLY)) {
        throw FileRefusedException.access(path, "is read-only");
      }
      refuseInUse(old, inUse);
    }
    return old;
  }

  static void refuseFolder(ControllerPath path, @Nullable FileItem old) throws IOException {
    if (old != null && old.directory()) {
      throw FileRefusedException.access(path, "is a folder");
    }
  }

  /** Refuses a file of a selected module, and a folder that contains one. */
  void refuseInUse(FileItem item, Predicate<String> inUse) throws IOException {
    if (item.directory()) {
      for (FileItem child : store.children(item.path())) {
        refuseInUse(child, inUse);
      }
      return;
    }
    String top = item.path().names().get(0);
    String name = item.path().name();
    if (top.equalsIgnoreCase(FileNameResolver.PROGRAMS)
        && FileItem.isModule(name)
        && inUse.test(ControllerPath.upper(FileItem.base(name)))) {
      throw FileRefusedException.access(item.path(), "is selected");
    }
  }
}
