package no.hials.crosscom.simulator.internal.files;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Predicate;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.code.ListFlag;
import no.hials.crosscom.protocol.code.ModulePart;
import no.hials.crosscom.simulator.FileTree;
import no.hials.crosscom.simulator.internal.data.BuiltInDataLists;
import org.jspecify.annotations.Nullable;

/**
 * The files of the controller as C3 Bridge serves them
 * (docs/reference/c3-messages.md#files-20-to-28). Error codes that were not measured are assumed:
 * {@link ErrorCode#GENERAL} for a missing item, {@link ErrorCode#ACCESS} for an item that exists
 * already or is in use, {@link ErrorCode#ARGUMENT} for arguments that make no sense.
 *
 * <p>Thread-safe. One lock is held during access to the disk too, because the result of a check
 * must stay true until the change is done.
 *
 * <p>A name is a full name or a KRC name. {@code inUse} tests whether the module of a name in
 * capital letters is selected; its files cannot be changed.
 */
public final class ControllerFileSystem implements FileTree {
  private static final List<String> FOLDERS =
      List.of("R1/Mada", "R1/Program", "R1/System", "R1/TP", "STEU/Mada");

  private static final int SETTABLE =
      Flags.of(
              FileAttribute.READ_ONLY,
              FileAttribute.HIDDEN,
              FileAttribute.SYSTEM,
              FileAttribute.ARCHIVE)
          .bits();

  private final ReentrantLock lock = new ReentrantLock();
  private final ItemStore store;
  private final FileNameResolver names;
  private final CheckedWriter writer;
  private final ItemCreator creator;
  private final Clock clock;
  private final long capacity;
  private long transfers;

  private ControllerFileSystem(ItemStore store, Clock clock, long capacity) throws IOException {
    if (capacity < 1 << 20) {
      throw new IllegalArgumentException("capacity must be 1 MiB or more, is " + capacity);
    }
    this.store = store;
    this.clock = Objects.requireNonNull(clock, "clock");
    this.capacity = capacity;
    names = new FileNameResolver(store);
    writer = new CheckedWriter(store, names, capacity);
    creator = new ItemCreator(store, names, writer);
    for (String folder : FOLDERS) {
      writer.makeFolders(ControllerPath.parse("/" + folder).path());
    }
  }

  public static ControllerFileSystem inMemory(Clock clock, long capacity) throws IOException {
    ControllerFileSystem files = new ControllerFileSystem(new MemoryStore(clock), clock, capacity);
    files.put("KRC:\\R1\\Mada\\$machine.dat", BuiltInDataLists.text("$MACHINE.DAT"));
    files.put("KRC:\\R1\\System\\$config.dat", BuiltInDataLists.text("$CONFIG.DAT"));
    return files;
  }

  public static ControllerFileSystem over(Path folder, Clock clock, long capacity)
      throws IOException {
    return new ControllerFileSystem(new FolderStore(folder, capacity), clock, capacity);
  }

  public static ControllerFileSystem of(FileTree files) {
    return (ControllerFileSystem) files;
  }

  private interface Work<T> {
    T run() throws IOException;
  }

  private <T> T locked(Work<T> work) throws IOException {
    lock.lock();
    try {
      return work.run();
    } finally {
      lock.unlock();
    }
  }

  private interface Change {
    void run() throws IOException;
  }

  private void lockedDo(Change change) throws IOException {
    locked(
        () -> {
          change.run();
          return true;
        });
  }

  // the file tree of Java code

  @Override
  public boolean isInMemory() {
    return store instanceof MemoryStore;
  }

  @Override
  public void put(String name, byte[] content) throws IOException {
    byte[] copy = content.clone();
    lockedDo(
        () -> {
          ControllerPath path = names.resolve(name);
          writer.makeFolders(path.parent());
          FileItem old = store.find(path);
          CheckedWriter.refuseFolder(path, old);
          writer.write(path, copy, old);
        });
  }

  @Override
  public byte[] get(String name) throws IOException {
    return read(name).clone();
  }

  @Override
  public boolean exists(String name) {
    try {
      item(name);
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  @Override
  public List<String> list(String folder) throws IOException {
    return locked(
        () ->
            store.children(names.existingFolder(folder).path()).stream()
                .map(item -> item.path().name())
                .toList());
  }

  @Override
  public void delete(String name) throws IOException {
    delete(name, true, module -> false);
  }

  // names

  /** Returns the full name of an item in capital letters, such as {@code KRC:\R1\PROGRAM\X.SRC}. */
  public String fullName(String name) throws IOException {
    return locked(() -> ControllerPath.upper(names.existing(name).path().fullName()));
  }

  /**
   * Returns the KRC name of an item in capital letters, such as {@code /R1/X.SRC}; with all folders
   * if the short form means another item.
   */
  public String krcName(String name) throws IOException {
    return locked(() -> names.krcName(names.existing(name)));
  }

  /**
   * Lists the programs and data lists below {@code KRC:\R1}, in the order in which the short form
   * of a name finds them.
   */
  public List<FileItem> modules() throws IOException {
    return locked(names::modules);
  }

  // reading

  public FileItem item(String name) throws IOException {
    return locked(() -> names.existing(name));
  }

  /** Returns the content of a file, which the caller must not change. */
  public byte[] read(String name) throws IOException {
    return locked(() -> store.read(names.existingFile(name)));
  }

  /**
   * Lists a folder. In a recursive list each folder is followed by its content (assumed).
   *
   * @param types the kinds of items, none for all
   * @param flags recursive, expand and long are used
   * @throws IOException if it is not a folder, or the list does not fit into an answer
   */
  public Listed list(String name, Flags<ItemType> types, Flags<ListFlag> flags) throws IOException {
    return locked(
        () -> {
          DirectoryListing listing = new DirectoryListing(types, flags);
          list(names.existingFolder(name), flags.has(ListFlag.RECURSIVE), listing);
          return new Listed(listing.names(), listing.infos());
        });
  }

  /**
   * The items of a folder.
   *
   * @param names the items
   * @param infos one for each item, or none at all
   */
  public record Listed(List<String> names, List<String> infos) {}

  private void list(FileItem folder, boolean recursive, DirectoryListing listing)
      throws IOException {
    for (FileItem item : store.children(folder.path())) {
      listing.add(item);
      if (recursive && item.directory()) {
        list(item, true, listing);
      }
    }
  }

  /**
   * Returns the time zone at a time as Windows has it: the minutes to add to local time for UTC.
   */
  public int biasMinutes(Instant time) {
    return -clock.getZone().getRules().getOffset(time).getTotalSeconds() / 60;
  }

  // changing

  /**
   * Sets attributes; others, such as signed, are ignored (assumed).
   *
   * @param attributes the new values
   * @param mask the attributes to change
   */
  public void setAttributes(String name, Flags<FileAttribute> attributes, Flags<FileAttribute> mask)
      throws IOException {
    lockedDo(
        () -> {
          FileItem item = names.existing(name);
          int changed = mask.bits() & SETTABLE;
          store.setAttributes(item, (item.attributes() & ~changed) | (attributes.bits() & changed));
        });
  }

  /**
   * Writes a file.
   *
   * @param content all of it; it must not change any more
   * @param flags whether an existing file, or a read-only one, is overwritten
   */
  public void write(String name, byte[] content, Flags<CopyFlag> flags, Predicate<String> inUse)
      throws IOException {
    lockedDo(
        () -> {
          ControllerPath path = names.resolve(name);
          writer.write(path, content, writer.overwritten(path, flags, inUse));
        });
  }

  /**
   * Creates a file, a module or a folder.
   *
   * @param name its name; the parts of a module have their own extensions
   * @param parts the parts of a module; if there are none, the extension of the name decides
   * @param always whether an existing item is overwritten
   * @param template the file to copy the content from. If empty, a part of a module is an empty
   *     program or data list (assumed)
   */
  public void create(
      String name,
      ItemType type,
      Flags<ModulePart> parts,
      boolean always,
      String template,
      Predicate<String> inUse)
      throws IOException {
    lockedDo(() -> creator.create(name, type, parts, always, template, inUse));
  }

  /**
   * Deletes an item, or all files of a module.
   *
   * @param name an item, or a module without extension
   * @param always whether to delete a read-only file, and a folder with its content
   */
  public void delete(String name, boolean always, Predicate<String> inUse) throws IOException {
    lockedDo(
        () -> {
          List<FileItem> items = names.existingOrModule(name);
          for (FileItem item : items) {
            refuseDelete(item, always, inUse);
          }
          for (FileItem item : items) {
            deleteAll(item);
          }
        });
  }

  private void refuseDelete(FileItem item, boolean always, Predicate<String> inUse)
      throws IOException {
    refuseTop(item);
    writer.refuseInUse(item, inUse);
    if (!always && item.readOnly()) {
      throw FileRefusedException.access(item.path(), "is read-only");
    }
    if (!always && item.directory() && !store.children(item.path()).isEmpty()) {
      throw FileRefusedException.access(item.path(), "is not empty");
    }
  }

  private static void refuseTop(FileItem item) throws IOException {
    if (item.path().names().size() < 2) {
      throw FileRefusedException.access(item.path(), "belongs to the controller");
    }
  }

  private void deleteAll(FileItem item) throws IOException {
    if (item.directory()) {
      for (FileItem child : store.children(item.path())) {
        deleteAll(child);
      }
    }
    store.delete(item);
  }

  /**
   * Copies a file, all files of a module, or with the flag recursive a folder with its content. The
   * copy has new times, and is not read-only (assumed).
   *
   * @param destination the name of the copy, not the folder to put it in
   * @param flags recursive and the two of overwriting are used
   */
  public void copy(
      String source, String destination, Flags<CopyFlag> flags, Predicate<String> inUse)
      throws IOException {
    lockedDo(
        () -> {
          List<FileItem> items = names.existingOrModule(source);
          if (!FileItem.isModule(source) && FileItem.isModule(items.get(0).path().name())) {
            copyModule(items, destination, flags, inUse);
            return;
          }
          FileItem item = items.get(0);
          ControllerPath path = names.resolve(destination);
          refuseWithin(item, path);
          FileItem old = writer.overwritten(path, flags, inUse);
          if (!item.directory()) {
            writer.write(path, store.read(item), old);
            return;
          }
          if (!flags.has(CopyFlag.RECURSIVE)) {
            throw FileRefusedException.argument(
                item.path() + " is a folder, the copy not recursive");
          }
          refuseFile(path, old);
          ControllerPath own = names.asStored(path);
          writer.reserve(checkNames(item, own), path);
          copyFolder(item, own);
        });
  }

  /** Copies the files of a module; the extension of the destination does not matter (assumed). */
  private void copyModule(
      List<FileItem> files, String destination, Flags<CopyFlag> flags, Predicate<String> inUse)
      throws IOException {
    String base = FileItem.isModule(destination) ? FileItem.base(destination) : destination;
    List<ControllerPath> paths = new ArrayList<>();
    long bytes = 0;
    for (FileItem file : files) {
      ControllerPath path = names.resolve(base + "." + FileItem.extension(file.path().name()));
      names.asStored(path);
      writer.overwritten(path, flags, inUse);
      paths.add(path);
      bytes += ItemStore.ITEM_COST + file.size();
    }
    writer.reserve(bytes, paths.get(0));
    for (int i = 0; i < paths.size(); i++) {
      writer.write(paths.get(i), store.read(files.get(i)), store.find(paths.get(i)));
    }
  }

  private static void refuseFile(ControllerPath path, @Nullable FileItem old) throws IOException {
    if (old != null) {
      throw FileRefusedException.access(path, "is a file");
    }
  }

  private static void refuseWithin(FileItem item, ControllerPath path) throws IOException {
    if (item.directory() && item.path().contains(path)) {
      throw FileRefusedException.argument(path + " is within " + item.path());
    }
  }

  /** Checks the length of the names in a copy, and returns the bytes that it needs. */
  private long checkNames(FileItem item, ControllerPath copy) throws IOException {
    long cost = ItemStore.ITEM_COST + item.size();
    if (item.directory()) {
      for (FileItem child : store.children(item.path())) {
        cost += checkNames(child, copy.child(child.path().name()));
      }
    }
    return cost;
  }

  private void copyFolder(FileItem folder, ControllerPath copy) throws IOException {
    store.makeFolder(copy);
    for (FileItem child : store.children(folder.path())) {
      ControllerPath path = copy.known(child.path().name());
      if (child.directory()) {
        copyFolder(child, path);
      } else {
        store.write(path, store.read(child));
      }
    }
  }

  /**
   * Moves a file, or a folder with its content.
   *
   * @param destination the new name, not the folder to put it in
   * @param flags the two of overwriting are used
   */
  public void move(
      String source, String destination, Flags<CopyFlag> flags, Predicate<String> inUse)
      throws IOException {
    lockedDo(
        () -> {
          FileItem item = names.existing(source);
          ControllerPath path = names.resolve(destination);
          refuseTop(item);
          writer.refuseInUse(item, inUse);
          ControllerPath own = names.asStored(path);
          if (item.path().isSame(path)) {
            store.move(item, own); // changes the case of the name
            return;
          }
          refuseWithin(item, path);
          FileItem old = writer.overwritten(path, flags, inUse);
          if (item.directory()) {
            refuseFile(path, old);
            checkNames(item, own);
          }
          if (old != null) {
            store.delete(old);
          }
          store.move(item, own);
        });
  }

  // transfers

  /** Reserves bytes for a transfer; returns false if too few are left. */
  boolean takeTransfer(long bytes) {
    lock.lock();
    try {
      boolean fits = bytes <= capacity - transfers && bytes <= Integer.MAX_VALUE - 64;
      transfers += fits ? bytes : 0;
      return fits;
    } finally {
      lock.unlock();
    }
  }

  void giveBackTransfer(long bytes) {
    lock.lock();
    try {
      transfers -= bytes;
    } finally {
      lock.unlock();
    }
  }
}
