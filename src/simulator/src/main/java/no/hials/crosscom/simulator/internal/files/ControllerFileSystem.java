package no.hials.crosscom.simulator.internal.files;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.Callable;
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
 * The files of the controller as C3 Bridge sees them: how names are found, and which code a refused
 * request gets. Where neither docs/reference/c3-messages.md nor c3-vectors.tsv has a code, it is
 * assumed: {@link ErrorCode#GENERAL} for an item that is missing, {@link ErrorCode#ACCESS} for an
 * item that exists already or is in use, {@link ErrorCode#ARGUMENT} for arguments that make no
 * sense.
 *
 * <p>Thread-safe. One lock is held during access to the disk too, because the result of a check
 * must stay true until the change is done.
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

  /** Creates the files of {@link FileTree#inMemory(Clock, long)}. */
  public static ControllerFileSystem inMemory(Clock clock, long capacity) throws IOException {
    ControllerFileSystem files = new ControllerFileSystem(new MemoryStore(clock), clock, capacity);
    files.put("KRC:\\R1\\Mada\\$machine.dat", BuiltInDataLists.text("$MACHINE.DAT"));
    files.put("KRC:\\R1\\System\\$config.dat", BuiltInDataLists.text("$CONFIG.DAT"));
    return files;
  }

  /** Opens the files of {@link FileTree#over(Path, Clock, long)}. */
  public static ControllerFileSystem over(Path folder, Clock clock, long capacity)
      throws IOException {
    return new ControllerFileSystem(new FolderStore(folder, capacity), clock, capacity);
  }

  /** Returns a file tree as what it always is. */
  public static ControllerFileSystem of(FileTree files) {
    return (ControllerFileSystem) files;
  }

  private <T> T locked(Callable<T> work) throws IOException {
    lock.lock();
    try {
      return work.call();
    } catch (IOException | RuntimeException e) {
      throw e;
    } catch (Exception e) {
      throw new IllegalStateException(e);
    } finally {
      lock.unlock();
    }
  }

  private interface Work {
    void run() throws IOException;
  }

  private void lockedDo(Work work) throws IOException {
    locked(
        () -> {
          work.run();
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

  /**
   * Returns the full name of an item, in capital letters
   * (docs/reference/c3-messages.md#files-20-to-28).
   *
   * @param name in either form
   * @return such as {@code KRC:\R1\PROGRAM\X.SRC}
   * @throws IOException if the item does not exist
   */
  public String fullName(String name) throws IOException {
    return locked(() -> ControllerPath.upper(names.existing(name).path().fullName()));
  }

  /**
   * Returns the KRC name of an item, in capital letters (c3-vectors.tsv, type 28).
   *
   * @param name in either form
   * @return such as {@code /R1/X.SRC}; with all folders if the short form means another item
   * @throws IOException if the item does not exist
   */
  public String krcName(String name) throws IOException {
    return locked(() -> names.krcName(names.existing(name)));
  }

  /**
   * Lists the programs and data lists below {@code KRC:\R1}, in the order in which the short form
   * of a name finds them.
   *
   * @return the files
   * @throws IOException if the files cannot be read
   */
  public List<FileItem> modules() throws IOException {
    return locked(names::modules);
  }

  // reading

  /**
   * Finds an item.
   *
   * @param name in either form
   * @return the item
   * @throws IOException if it is not there
   */
  public FileItem item(String name) throws IOException {
    return locked(() -> names.existing(name));
  }

  /**
   * Gives a file's content.
   *
   * @param name in either form
   * @return the content, to be read only
   * @throws IOException if there is none
   */
  public byte[] read(String name) throws IOException {
    return locked(() -> store.read(names.existingFile(name)));
  }

  /**
   * Lists a folder. That a folder of a recursive list is followed by what is in it is assumed.
   *
   * @param name the folder
   * @param types the kinds of items, none for all
   * @param flags recursive, expand and long count
   * @return the items
   * @throws IOException if it is none, or they do not fit into an answer
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
   * What is in a folder.
   *
   * @param names the items
   * @param infos one an item, or none
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
   * Gives the time zone at some time as Windows has it.
   *
   * @param time when
   * @return minutes to be added to local time for UTC
   */
  public int biasMinutes(Instant time) {
    return -clock.getZone().getRules().getOffset(time).getTotalSeconds() / 60;
  }

  // changing

  /**
   * Sets attributes; those that a file cannot be given, such as signed, are left out, which is
   * assumed.
   *
   * @param name the item
   * @param attributes those to be set
   * @param mask those to be changed
   * @throws IOException if it is not there
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
   * Writes a file that may be there.
   *
   * @param name the file
   * @param content all of it, which nobody changes any more
   * @param flags whether one that is there, or is read-only, is overwritten
   * @param inUse whether the module of a name in capital letters is selected
   * @throws IOException if it is refused
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
   * @param name its name; the parts of a module have their own ends
   * @param type the kind
   * @param parts what a module has; what the name's end says if there are none
   * @param always whether one that is there is written again
   * @param template the file to take the content from, empty for none. Without one, a part of a
   *     module is an empty program or data list, which is assumed
   * @param inUse whether the module of a name in capital letters is selected
   * @throws IOException if it is refused
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
   * Deletes an item.
   *
   * @param name the item
   * @param always whether a file that is read-only, and a folder with all that is in it, is deleted
   * @param inUse whether the module of a name in capital letters is selected
   * @throws IOException if it is refused
   */
  public void delete(String name, boolean always, Predicate<String> inUse) throws IOException {
    lockedDo(
        () -> {
          FileItem item = names.existing(name);
          refuseTop(item);
          writer.refuseInUse(item, inUse);
          if (!always && item.readOnly()) {
            throw FileRefusedException.access(item.path(), "is read-only");
          }
          if (!always && item.directory() && !store.children(item.path()).isEmpty()) {
            throw FileRefusedException.access(item.path(), "is not empty");
          }
          deleteAll(item);
        });
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
   * Copies a file, or a folder with all that is in it if the flags say recursive. The copy is new:
   * its times are now, and it is not read-only, which is assumed.
   *
   * @param source the item
   * @param destination its copy, not the folder to be put in
   * @param flags recursive and the two of overwriting count
   * @param inUse whether the module of a name in capital letters is selected
   * @throws IOException if it is refused
   */
  public void copy(
      String source, String destination, Flags<CopyFlag> flags, Predicate<String> inUse)
      throws IOException {
    lockedDo(
        () -> {
          FileItem item = names.existing(source);
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

  /** Checks that nothing in a folder gets too long a name; gives what a copy costs. */
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
   * Moves a file, or a folder with all that is in it.
   *
   * @param source the item
   * @param destination its new name, not the folder to be put in
   * @param flags the two of overwriting count
   * @param inUse whether the module of a name in capital letters is selected
   * @throws IOException if it is refused
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

  /** Takes room for a transfer; false if there is not so much. */
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

  /** Gives room back. */
  void giveBackTransfer(long bytes) {
    lock.lock();
    try {
      transfers -= bytes;
    } finally {
      lock.unlock();
    }
  }
}
