package no.hials.crosscom.simulator;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.ParseResult;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.value.KrlEncoding;
import no.hials.crosscom.simulator.internal.files.ControllerFileSystem;
import no.hials.crosscom.simulator.internal.files.FileItem;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Loads the programs and data lists of the file tree before one of them is selected. It loads all
 * new and changed files, because programs may call each other. A program cannot be selected any
 * more when its file is deleted, but its module stays loaded.
 *
 * <p>The lists of the controller, {@code $config.dat} and the like, are loaded if they have changed
 * since this object was created. That a change takes effect at the next selection is assumed.
 *
 * <p>Thread-safe.
 */
final class FileTreePrograms {
  private static final Logger LOG = LoggerFactory.getLogger(FileTreePrograms.class);

  /**
   * The bytes of all files that a selection loads, and of the programs and lists that are still
   * loaded from others: their trees take as much again; assumed.
   */
  static final long MAX_TOTAL = 8 << 20;

  /** The largest file that a selection loads, so that a client cannot fill the memory; assumed. */
  static final int MAX_LENGTH = 4 << 20;

  private final ControllerFileSystem files;
  private final ModuleLoader loader;

  /** The loaded modules, by the name of their file in capital letters without the extension. */
  private final Map<String, Module> loaded = new HashMap<>();

  /**
   * The lengths of the files whose trees are kept, by the names of their modules and {@code .DAT}
   * or {@code .SRC}; guarded by {@link #loading}.
   */
  private final Map<String, Long> kept = new HashMap<>();

  /** Held while files are parsed and loaded, without the lock of this object. */
  private final Object loading = new Object();

  /** {@link #MAX_TOTAL} in addition to the files that were loaded before, such as an archive. */
  private long maxTotal;

  private final LoadingMode mode;

  /**
   * The files that were loaded before.
   *
   * @param modules the names of their modules, by the full names of the files in capital letters
   * @param mode how new and changed files are loaded
   */
  record Loaded(Map<String, String> modules, LoadingMode mode) {
    static final Loaded NOTHING = new Loaded(Map.of(), LoadingMode.STRICT);
  }

  FileTreePrograms(FileTree files, ModuleLoader loader, Loaded before) {
    this(files, loader, before, MAX_TOTAL);
  }

  FileTreePrograms(FileTree files, ModuleLoader loader, Loaded before, long maxTotal) {
    this.files = ControllerFileSystem.of(files);
    this.loader = loader;
    this.mode = before.mode();
    this.maxTotal = maxTotal;
    try {
      modules().forEach((name, module) -> keep(name, module, before));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Keeps the lists of the controller, and what was loaded before, as it is now. */
  private void keep(String name, Module module, Loaded before) {
    List<String> modules =
        module.items.values().stream()
            .map(item -> before.modules().getOrDefault(upper(item.path().fullName()), ""))
            .toList();
    if (modules.contains("") && !name.startsWith("$")) {
      return;
    }
    read(module);
    // that of the program, which comes after its list
    module.name = modules.get(modules.size() - 1);
    module.hadProgram = module.hasProgram();
    if (!name.startsWith("$")) {
      module.items.forEach((end, item) -> kept.put(part(module.name, end), item.size()));
      maxTotal += module.items.values().stream().mapToLong(FileItem::size).sum();
    }
    loaded.put(name, module);
  }

  private static String upper(String text) {
    return text.toUpperCase(Locale.ROOT);
  }

  /** The files of a module. */
  private static final class Module {
    /** The files by extension, in lower case; the data list comes first. */
    private final Map<String, FileItem> items = new LinkedHashMap<>();

    /** The contents of those that can be read. */
    private final Map<String, byte[]> parts = new LinkedHashMap<>();

    /** The errors; empty if the module was loaded. */
    private List<KrlError> errors = List.of();

    /** The name of the module, which can differ from that of its file. */
    private String name = "";

    /** The reason why a file cannot be read; null if all can. */
    private @Nullable KrlError unreadable;

    /** Whether it has a program, or had one that was deleted since. */
    private boolean hadProgram;

    boolean hasProgram() {
      return items.keySet().stream().anyMatch(end -> !end.equals("dat"));
    }

    boolean isSame(Module other) {
      return Objects.equals(unreadable, other.unreadable)
          && parts.keySet().equals(other.parts.keySet())
          && parts.keySet().stream()
              .allMatch(end -> Arrays.equals(parts.get(end), other.parts.get(end)));
    }
  }

  /**
   * Loads new and changed files, and finds the module that a client means.
   *
   * @param name such as {@code /R1/X.SRC}, {@code /R1/X()}, {@code KRC:\R1\PROGRAM\X.SRC} or {@code
   *     X}, in any case
   * @return the name to select the module by; if no file has that name, the name without folders
   *     and extension
   * @throws KrlFileException if its files have errors or have been deleted, or all files together
   *     are too large
   */
  String prepare(String name) throws KrlFileException {
    String key = key(name);
    synchronized (loading) {
      Map<String, Module> found;
      try {
        found = modules();
      } catch (IOException e) {
        throw error(name, "the files cannot be read: " + e.getMessage());
      }
      checkTotal(name, found);
      found.forEach(this::loadIfChanged);
      Module module = loaded(key);
      if (module == null) {
        return key;
      }
      // only its data list may be left
      if (!found.containsKey(key) || (module.hadProgram && !module.hasProgram())) {
        throw error(name, "the files of " + key + " have been deleted");
      }
      if (!module.errors.isEmpty()) {
        throw new KrlFileException(module.errors);
      }
      return module.name;
    }
  }

  private synchronized @Nullable Module loaded(String key) {
    return loaded.get(key);
  }

  /** Checks the sizes of all files before one is read. */
  private void checkTotal(String name, Map<String, Module> found) throws KrlFileException {
    long total = 0;
    Map<String, Long> others = new HashMap<>(kept);
    for (Map.Entry<String, Module> entry : found.entrySet()) {
      Module old = loaded(entry.getKey());
      for (Map.Entry<String, FileItem> item : entry.getValue().items.entrySet()) {
        total += item.getValue().size();
        others.remove(part(old == null ? entry.getKey() : old.name, item.getKey()));
      }
    }
    for (long other : others.values()) {
      total += other;
    }
    if (total > maxTotal) {
      throw error(
          name,
          "all programs and data lists, those deleted since they were loaded too, have at most "
              + maxTotal
              + " bytes, have "
              + total);
    }
  }

  private static String part(String module, String end) {
    return module.toUpperCase(Locale.ROOT) + (end.equals("dat") ? ".DAT" : ".SRC");
  }

  /** Loads the files of a module one after the other, so that one tree is new at a time. */
  private void loadIfChanged(String key, Module module) {
    read(module);
    Module old = loaded(key);
    if (old != null && old.isSame(module)) {
      return;
    }
    module.hadProgram = module.hasProgram() || (old != null && old.hadProgram);
    module.name = key;
    List<KrlError> errors = new ArrayList<>();
    if (module.unreadable != null) {
      errors.add(module.unreadable);
    }
    module.parts.forEach((end, content) -> errors.addAll(load(key, module, old, end, content)));
    module.errors = List.copyOf(errors);
    if (!errors.isEmpty()) {
      LOG.warn("{} has errors: {}", key, new KrlFileException(errors).getMessage());
    }
    synchronized (this) {
      if (loaded.get(key) == old) {
        loaded.put(key, module);
      }
    }
  }

  /** Loads a file; returns the errors. A failure of the parser is an error of the file. */
  private List<KrlError> load(
      String key, Module module, @Nullable Module old, String end, byte[] content) {
    String file = Objects.requireNonNull(module.items.get(end)).path().name();
    try {
      ParseResult result = KrlParser.parse(file, KrlEncoding.decode(content));
      synchronized (this) {
        if (loaded.get(key) != old) {
          return List.of(); // loaded from elsewhere meanwhile
        }
        module.name = loader.take(file, result, mode).name();
      }
      if (!module.name.startsWith("$")) {
        kept.put(part(module.name, end), (long) content.length);
      }
      return List.of();
    } catch (KrlFileException e) {
      return e.errors();
    } catch (RuntimeException | VirtualMachineError e) {
      LOG.warn("{} cannot be loaded", file, e);
      return error(file, "the file cannot be loaded: " + e).errors();
    }
  }

  /**
   * Shows a module loaded from elsewhere as a file, which is not loaded again.
   *
   * @param ending src, sub or dat
   */
  synchronized void show(String name, String ending, byte[] content) {
    if (!files.isInMemory() || name.startsWith("$")) {
      return;
    }
    String file = name + "." + ending;
    FileItem item;
    try {
      files.put("/R1/" + file, content);
      item = files.item("/R1/" + file);
    } catch (IOException e) {
      LOG.debug("{} is not shown as a file: {}", file, e.getMessage());
      return;
    }
    // parts that a client has changed are not loaded yet, so they keep their old state
    Module module = new Module();
    Module old = loaded.get(key(file));
    if (old != null) {
      module.parts.putAll(old.parts);
      module.items.putAll(old.items);
    }
    module.name = name;
    module.parts.put(ending, content);
    module.items.put(ending, item);
    module.hadProgram = module.hasProgram();
    loaded.put(key(file), module);
  }

  private static KrlFileException error(String file, String message) {
    return new KrlFileException(List.of(new KrlError(new Position(file, 1, 1), message)));
  }

  /** Returns the name of a module from the forms that clients write. */
  private static String key(String name) {
    String bare = name.strip();
    bare = bare.substring(Math.max(bare.lastIndexOf('/'), bare.lastIndexOf('\\')) + 1);
    int brace = bare.indexOf('(');
    bare = brace < 0 ? bare : bare.substring(0, brace).strip();
    int dot = bare.lastIndexOf('.');
    return (dot < 0 ? bare : bare.substring(0, dot)).toUpperCase(Locale.ROOT);
  }

  /**
   * Finds all modules, unread; if several folders have a file of the same name, the first is used.
   */
  private Map<String, Module> modules() throws IOException {
    List<FileItem> items = new ArrayList<>(files.modules());
    // data lists are loaded before their programs
    items.sort((a, b) -> Boolean.compare(!isList(a), !isList(b)));
    Map<String, Module> modules = new LinkedHashMap<>();
    for (FileItem item : items) {
      Module module = modules.computeIfAbsent(key(item.path().name()), key -> new Module());
      module.items.putIfAbsent(end(item), item);
    }
    return modules;
  }

  /** Reads the files of a module; the other modules can be loaded if one cannot be read. */
  private void read(Module module) {
    module.items.forEach(
        (end, item) -> {
          String file = item.path().name();
          try {
            ModuleLoader.checkLength(file, item.size(), MAX_LENGTH);
            module.parts.put(end, files.read(item.path().fullName()));
          } catch (IOException e) {
            module.unreadable =
                error(file, "the file cannot be read: " + e.getMessage()).errors().get(0);
          } catch (KrlFileException e) {
            module.unreadable = e.errors().get(0);
          }
        });
  }

  private static boolean isList(FileItem item) {
    return end(item).equals("dat");
  }

  private static String end(FileItem item) {
    String name = item.path().name();
    return name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
  }
}
