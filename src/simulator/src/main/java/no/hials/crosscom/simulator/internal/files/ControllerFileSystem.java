package no.hials.crosscom.simulator.internal.files;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
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
import org.jspecify.annotations.Nullable;

/**
 * The rules of the tree: how names are found, and what is refused with which code. Where neither
 * c3-bridge.md nor c3-vectors.tsv says a code, it is assumed: {@link ErrorCode#GENERAL} for what is
 * not there, {@link ErrorCode#ACCESS} for what is in the way or in use, {@link ErrorCode#ARGUMENT}
 * for what makes no sense.
 *
 * <p>Thread-safe: one lock, which is held during access to the file system, too, as what a rule has
 * checked must not change before it is done.
 */
public final class ControllerFileSystem {
  private static final String PROGRAMS = "R1";
  private static final String PROGRAM_FOLDER = "Program";
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
  private final Clock clock;
  private final long capacity;
  private long transfers;

  private ControllerFileSystem(ItemStore store, Clock clock, long capacity) throws IOException {
    this.store = store;
    this.clock = clock;
    this.capacity = capacity;
    for (String folder : FOLDERS) {
      makeFolders(ControllerPath.parse("/" + folder).path());
    }
  }

  /**
   * Makes a tree in memory, with the folders of a KR C4.
   *
   * @param clock gives the times of the files, and the time zone
   * @param capacity how many bytes it may hold; as much again are for transfers
   * @return the tree
   */
  public static ControllerFileSystem inMemory(Clock clock, long capacity) {
    try {
      return new ControllerFileSystem(new MemoryStore(clock), clock, capacity);
    } catch (IOException e) {
      throw new IllegalArgumentException("the folders need a larger capacity: " + e, e);
    }
  }

  /**
   * Makes a tree of a folder of this machine, in which the folders of a KR C4 are made if they are
   * missing.
   *
   * @param folder what {@code KRC:\} is
   * @param clock gives the time zone
   * @param capacity as for {@link #inMemory}; what is in the folder already counts
   * @return the tree
   * @throws IOException if the folder cannot be used
   */
  public static ControllerFileSystem over(Path folder, Clock clock, long capacity)
      throws IOException {
    return new ControllerFileSystem(new FolderStore(folder, capacity), clock, capacity);
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

  // names

  /** Finds the place that a name means, whether something is there or not. */
  private ControllerPath resolve(String name) throws IOException {
    ControllerPath.Parsed parsed = ControllerPath.parse(name);
    ControllerPath path = parsed.path();
    if (!parsed.krcForm() || path.names().size() != 2 || store.find(path) != null) {
      return path;
    }
    FileItem module = search(path);
    if (module != null) {
      return module.path();
    }
    // a new program of the short form belongs where c3-bridge.md, type 27, finds one
    boolean program = path.names().get(0).equalsIgnoreCase(PROGRAMS) && path.name().contains(".");
    return program
        ? ControllerPath.ROOT.child(path.names().get(0)).child(PROGRAM_FOLDER).child(path.name())
        : path;
  }

  /** Finds the file that the short form {@code /R1/X.SRC} means: programs first, then the rest. */
  private @Nullable FileItem search(ControllerPath krcName) throws IOException {
    FileItem top = store.find(krcName.parent());
    if (top == null || !top.directory()) {
      return null;
    }
    FileItem program = store.find(top.path().known(PROGRAM_FOLDER));
    FileItem found =
        program != null && program.directory() ? search(program, krcName.name()) : null;
    return found != null ? found : search(top, krcName.name());
  }

  private @Nullable FileItem search(FileItem folder, String name) throws IOException {
    for (FileItem item : store.children(folder.path())) {
      FileItem found = item.directory() ? search(item, name) : item;
      if (found != null && found.path().name().equalsIgnoreCase(name)) {
        return found;
      }
    }
    return null;
  }

  private FileItem existing(String name) throws IOException {
    ControllerPath path = resolve(name);
    FileItem item = store.find(path);
    if (item == null) {
      throw FileRefusedException.missing(path);
    }
    return item;
  }

  private FileItem existingFile(String name) throws IOException {
    FileItem item = existing(name);
    if (item.directory()) {
      throw FileRefusedException.argument(item.path() + " is a folder");
    }
    return item;
  }

  /**
   * Gives the full name of an item, in capital letters as c3-bridge.md, type 27, has it.
   *
   * @param name in either form
   * @return such as {@code KRC:\R1\PROGRAM\X.SRC}
   * @throws IOException if it is not there
   */
  public String fullName(String name) throws IOException {
    return locked(() -> ControllerPath.upper(existing(name).path().fullName()));
  }

  /**
   * Gives the KRC name of an item, in capital letters (c3-vectors.tsv, type 28).
   *
   * @param name in either form
   * @return such as {@code /R1/X.SRC}; with all folders if the short form means another item
   * @throws IOException if it is not there
   */
  public String krcName(String name) throws IOException {
    return locked(
        () -> {
          FileItem item = existing(name);
          List<String> names = item.path().names();
          if (!item.directory() && names.size() > 1) {
            String brief = "/" + names.get(0) + "/" + item.path().name();
            if (resolve(brief).isSame(item.path())) {
              return ControllerPath.upper(brief);
            }
          }
          return ControllerPath.upper("/" + String.join("/", names));
        });
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
    return locked(() -> existing(name));
  }

  /**
   * Gives a file's content.
   *
   * @param name in either form
   * @return the content, to be read only
   * @throws IOException if there is none
   */
  public byte[] read(String name) throws IOException {
    return locked(() -> store.read(existingFile(name)));
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
          list(existingFolder(name), flags.has(ListFlag.RECURSIVE), listing);
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

  private FileItem existingFolder(String name) throws IOException {
    FileItem folder = existing(name);
    if (!folder.directory()) {
      throw FileRefusedException.argument(folder.path() + " is no folder");
    }
    return folder;
  }

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
   * Lists the names in a folder, however many they are.
   *
   * @param name the folder
   * @return the last names
   * @throws IOException if it is none
   */
  public List<String> names(String name) throws IOException {
    return locked(
        () ->
            store.children(existingFolder(name).path()).stream()
                .map(item -> item.path().name())
                .toList());
  }

  /**
   * Lists all programs and data lists below {@code KRC:\R1}, in the order in which the short form
   * of a name finds them.
   *
   * @return the files
   * @throws IOException if the tree cannot be read
   */
  public List<FileItem> modules() throws IOException {
    return locked(
        () -> {
          List<FileItem> modules = new ArrayList<>();
          FileItem top = store.find(ControllerPath.ROOT.known(PROGRAMS));
          if (top != null && top.directory()) {
            modules(top, modules);
          }
          ControllerPath first = ControllerPath.ROOT.known(PROGRAMS).known(PROGRAM_FOLDER);
          List<FileItem> sorted = new ArrayList<>(modules);
          sorted.removeIf(item -> !first.contains(item.path()));
          modules.removeIf(item -> first.contains(item.path()));
          sorted.addAll(modules);
          return sorted;
        });
  }

  private void modules(FileItem folder, List<FileItem> modules) throws IOException {
    for (FileItem item : store.children(folder.path())) {
      if (item.directory()) {
        modules(item, modules);
      } else if (FileItem.isModule(item.path().name())) {
        modules.add(item);
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
          FileItem item = existing(name);
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
          ControllerPath path = resolve(name);
          write(path, content, overwritten(path, flags, inUse));
        });
  }

  /**
   * Writes a file whatever is there, and makes the folders that it needs.
   *
   * @param name the file
   * @param content all of it, which nobody changes any more
   * @throws IOException if it cannot be
   */
  public void put(String name, byte[] content) throws IOException {
    lockedDo(
        () -> {
          ControllerPath path = resolve(name);
          makeFolders(path.parent());
          FileItem old = store.find(path);
          refuseFolder(path, old);
          write(path, content, old);
        });
  }

  private void makeFolders(ControllerPath folder) throws IOException {
    FileItem item = store.find(folder);
    if (item == null) {
      makeFolders(folder.parent());
      reserve(ItemStore.ITEM_COST, folder);
      store.makeFolder(own(folder));
    } else if (!item.directory()) {
      throw FileRefusedException.access(folder, "is no folder");
    }
  }

  private void write(ControllerPath path, byte[] content, @Nullable FileItem old)
      throws IOException {
    if (old == null) {
      reserve(content.length + (long) ItemStore.ITEM_COST, path);
      store.write(own(path), content);
    } else {
      reserve(content.length - old.size(), path);
      store.write(old.path(), content);
    }
  }

  /** Gives the place of something new with its folders in their own spelling. */
  private ControllerPath own(ControllerPath path) throws IOException {
    FileItem parent = store.find(path.parent());
    if (parent == null || !parent.directory() || path.isRoot()) {
      throw FileRefusedException.missing(path.parent());
    }
    return parent.path().known(path.name());
  }

  private void reserve(long bytes, ControllerPath path) throws IOException {
    if (bytes > 0 && bytes > capacity - store.used()) {
      throw tooLarge(path, capacity);
    }
  }

  static FileRefusedException tooLarge(ControllerPath path, long limit) {
    return new FileRefusedException(
        ErrorCode.MEMORY, path + " does not fit, the limit is " + limit + " bytes in all");
  }

  /** Checks what a copy takes the place of; null if there is nothing. */
  private @Nullable FileItem overwritten(
      ControllerPath path, Flags<CopyFlag> flags, Predicate<String> inUse) throws IOException {
    FileItem old = store.find(path);
    if (old != null) {
      refuseFolder(path, old);
      if (!flags.has(CopyFlag.OVERWRITE)) {
        throw FileRefusedException.access(path, "is there already");
      }
      if (old.readOnly() && !flags.has(CopyFlag.OVERWRITE_READ_ONLY)) {
        throw FileRefusedException.access(path, "is read-only");
      }
      refuseInUse(old, inUse);
    }
    return old;
  }

  private static void refuseFolder(ControllerPath path, @Nullable FileItem old) throws IOException {
    if (old != null && old.directory()) {
      throw FileRefusedException.access(path, "is a folder");
    }
  }

  /** Refuses an item that is, or has in it, a file of a selected module. */
  private void refuseInUse(FileItem item, Predicate<String> inUse) throws IOException {
    if (item.directory()) {
      for (FileItem child : store.children(item.path())) {
        refuseInUse(child, inUse);
      }
      return;
    }
    List<String> names = item.path().names();
    String name = item.path().name();
    if (names.get(0).equalsIgnoreCase(PROGRAMS)
        && FileItem.isModule(name)
        && inUse.test(ControllerPath.upper(FileItem.base(name)))) {
      throw FileRefusedException.access(item.path(), "is selected");
    }
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
    lockedDo(
        () -> {
          switch (type) {
            case DIRECTORY -> createFolder(resolve(name), always);
            case MODULE -> createModule(name, parts, always, template, inUse);
            case BINARY, TEXT, RAW -> {
              byte[] content =
                  template.isEmpty() ? new byte[0] : store.read(existingFile(template));
              createFiles(Map.of(resolve(name), content), always, inUse);
            }
            default ->
                throw FileRefusedException.argument(
                    "an item of type " + type + " cannot be created");
          }
        });
  }

  private void createFolder(ControllerPath path, boolean always) throws IOException {
    FileItem old = store.find(path);
    if (old == null) {
      ControllerPath own = own(path);
      reserve(ItemStore.ITEM_COST, path);
      store.makeFolder(own);
    } else if (!always || !old.directory()) {
      throw FileRefusedException.access(path, "is there already");
    }
  }

  private void createModule(
      String name,
      Flags<ModulePart> parts,
      boolean always,
      String template,
      Predicate<String> inUse)
      throws IOException {
    boolean ended = FileItem.isModule(name);
    String base = ended ? FileItem.base(name) : name;
    List<String> ends = new ArrayList<>();
    for (ModulePart part : List.of(ModulePart.SUB, ModulePart.SRC, ModulePart.DAT)) {
      if (parts.has(part)) {
        ends.add(part.name().toLowerCase(Locale.ROOT));
      }
    }
    if (ends.isEmpty() && ended) {
      ends.add(FileItem.extension(name));
    }
    if (ends.isEmpty()) {
      throw FileRefusedException.argument("a module needs a part, the flags are " + parts);
    }
    Map<ControllerPath, byte[]> files = new LinkedHashMap<>();
    for (String end : ends) {
      ControllerPath path = resolve(base + "." + end);
      files.put(path, content(path, end, template));
    }
    createFiles(files, always, inUse);
  }

  private byte[] content(ControllerPath path, String end, String template) throws IOException {
    if (!template.isEmpty()) {
      String base = FileItem.isModule(template) ? FileItem.base(template) : template;
      return store.read(existingFile(base + "." + end));
    }
    String name = FileItem.base(path.name());
    String text =
        end.equals("dat") ? "DEFDAT " + name + "\r\nENDDAT\r\n" : "DEF " + name + "( )\r\nEND\r\n";
    return ("&ACCESS RVP\r\n" + text).getBytes(StandardCharsets.ISO_8859_1);
  }

  /** Creates all of some files or none. */
  private void createFiles(
      Map<ControllerPath, byte[]> files, boolean always, Predicate<String> inUse)
      throws IOException {
    long bytes = 0;
    for (Map.Entry<ControllerPath, byte[]> file : files.entrySet()) {
      ControllerPath path = file.getKey();
      own(path);
      FileItem old = store.find(path);
      refuseFolder(path, old);
      if (old != null && !always) {
        throw FileRefusedException.access(path, "is there already");
      }
      if (old != null) {
        refuseInUse(old, inUse);
      }
      bytes += file.getValue().length + (long) ItemStore.ITEM_COST;
    }
    reserve(bytes, files.keySet().iterator().next());
    for (Map.Entry<ControllerPath, byte[]> file : files.entrySet()) {
      write(file.getKey(), file.getValue(), store.find(file.getKey()));
    }
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
          FileItem item = existing(name);
          refuseTop(item);
          refuseInUse(item, inUse);
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
          FileItem item = existing(source);
          ControllerPath path = resolve(destination);
          refuseWithin(item, path);
          FileItem old = overwritten(path, flags, inUse);
          if (!item.directory()) {
            write(path, store.read(item), old);
            return;
          }
          if (!flags.has(CopyFlag.RECURSIVE)) {
            throw FileRefusedException.argument(
                item.path() + " is a folder, the copy not recursive");
          }
          refuseFile(path, old);
          ControllerPath own = own(path);
          reserve(checkNames(item, own), path);
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
          FileItem item = existing(source);
          ControllerPath path = resolve(destination);
          refuseTop(item);
          refuseInUse(item, inUse);
          ControllerPath own = own(path);
          if (item.path().isSame(path)) {
            store.move(item, own); // changes the case of the name
            return;
          }
          refuseWithin(item, path);
          FileItem old = overwritten(path, flags, inUse);
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
