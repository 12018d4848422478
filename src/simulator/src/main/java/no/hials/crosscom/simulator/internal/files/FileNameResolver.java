package no.hials.crosscom.simulator.internal.files;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Finds the items that the names in requests mean. Not thread-safe. */
final class FileNameResolver {
  /** The folder of programs; the short form of a name leaves it out. */
  static final String PROGRAMS = "R1";

  private static final String PROGRAM_FOLDER = "Program";

  private static final List<String> MODULE_EXTENSIONS = List.of("src", "sub", "dat");

  private final ItemStore store;

  FileNameResolver(ItemStore store) {
    this.store = store;
  }

  /** Finds the path that a name means, whether an item is there or not. */
  ControllerPath resolve(String name) throws IOException {
    ControllerPath.Parsed parsed = ControllerPath.parse(name);
    ControllerPath path = parsed.path();
    if (!parsed.krcForm() || path.names().size() != 2 || store.find(path) != null) {
      return path;
    }
    FileItem module = search(path);
    if (module != null) {
      return module.path();
    }
    // a new program of the short form belongs where type 27 finds one
    // (docs/reference/c3-messages.md#files-20-to-28)
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
    for (FileItem item : filesFirst(folder)) {
      FileItem found = item.directory() ? search(item, name) : item;
      if (found != null && found.path().name().equalsIgnoreCase(name)) {
        return found;
      }
    }
    return null;
  }

  /** Returns the content of a folder; files come first, since a folder may hold copies of them. */
  private List<FileItem> filesFirst(FileItem folder) throws IOException {
    List<FileItem> items = new ArrayList<>(store.children(folder.path()));
    items.sort(Comparator.comparing(FileItem::directory));
    return items;
  }

  FileItem existing(String name) throws IOException {
    ControllerPath path = resolve(name);
    FileItem item = store.find(path);
    if (item == null) {
      throw FileRefusedException.missing(path);
    }
    return item;
  }

  /**
   * Returns the item of a name, or the files of the module that a name without extension means
   * (docs/reference/c3-messages.md#files-20-to-28).
   */
  List<FileItem> existingOrModule(String name) throws IOException {
    FileItem item = store.find(resolve(name));
    if (item != null) {
      return List.of(item);
    }
    List<FileItem> files = new ArrayList<>();
    for (String extension : MODULE_EXTENSIONS) {
      FileItem file = store.find(resolve(name + "." + extension));
      if (file != null && !file.directory()) {
        files.add(file);
      }
    }
    if (files.isEmpty()) {
      throw FileRefusedException.missing(resolve(name));
    }
    return files;
  }

  FileItem existingFile(String name) throws IOException {
    FileItem item = existing(name);
    if (item.directory()) {
      throw FileRefusedException.argument(item.path() + " is a folder");
    }
    return item;
  }

  FileItem existingFolder(String name) throws IOException {
    FileItem folder = existing(name);
    if (!folder.directory()) {
      throw FileRefusedException.argument(folder.path() + " is not a folder");
    }
    return folder;
  }

  /** Returns the path of a new item, its folders spelled as they are stored. */
  ControllerPath asStored(ControllerPath path) throws IOException {
    FileItem parent = store.find(path.parent());
    if (parent == null || !parent.directory() || path.isRoot()) {
      throw FileRefusedException.missing(path.parent());
    }
    return parent.path().known(path.name());
  }

  String krcName(FileItem item) throws IOException {
    List<String> names = item.path().names();
    if (!item.directory() && names.size() > 1) {
      String brief = "/" + names.get(0) + "/" + item.path().name();
      if (resolve(brief).isSame(item.path())) {
        return ControllerPath.upper(brief);
      }
    }
    return ControllerPath.upper("/" + String.join("/", names));
  }

  /** Lists the programs and data lists below {@code KRC:\R1} in the order of {@link #search}. */
  List<FileItem> modules() throws IOException {
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
  }

  private void modules(FileItem folder, List<FileItem> modules) throws IOException {
    for (FileItem item : filesFirst(folder)) {
      if (item.directory()) {
        modules(item, modules);
      } else if (FileItem.isModule(item.path().name())) {
        modules.add(item);
      }
    }
  }
}
