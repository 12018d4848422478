package no.hials.crosscom.simulator;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.ParseResult;
import no.hials.crosscom.lang.Position;
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
  private static final Logger log = LoggerFactory.getLogger(FileTreePrograms.class);

  private final ControllerFileSystem files;
  private final ModuleLoader loader;

  /** The loaded modules, by the name of their file in capital letters without the extension. */
  private final Map<String, Module> loaded = new HashMap<>();

  /** Held while files are parsed, without the lock of this object. */
  private final Object parsing = new Object();

  /** The files that were parsed and not loaded yet, by their contents; guarded by this. */
  private final Map<Text, ParseResult> parsed = new HashMap<>();

  /** A file and its text. */
  private record Text(String file, String text) {}

  FileTreePrograms(FileTree files, ModuleLoader loader) {
    this.files = ControllerFileSystem.of(files);
    this.loader = loader;
    try {
      modules().forEach(this::keepList);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void keepList(String name, Module module) {
    if (name.startsWith("$")) {
      loaded.put(name, module);
    }
  }

  /** The files of a module. */
  private static final class Module {
    /** Their contents by extension, in lower case; the data list comes first. */
    private final Map<String, byte[]> parts = new LinkedHashMap<>();

    private final Map<String, String> names = new HashMap<>();

    /** The errors; empty if the module was loaded. */
    private List<KrlError> errors = List.of();

    /** The name of the module, which can differ from that of its file. */
    private String name = "";

    /** The reason why a file cannot be read; null if all can. */
    private @Nullable KrlError unreadable;

    /** Whether it has a program, or had one that was deleted since. */
    private boolean hadProgram;

    boolean hasProgram() {
      return parts.keySet().stream().anyMatch(end -> !end.equals("dat"));
    }

    /** Returns the files that are small enough, the data list first. */
    List<Text> texts() {
      List<Text> texts = new ArrayList<>();
      parts.forEach(
          (end, content) -> {
            if (content.length <= ModuleLoader.MAX_LENGTH) {
              texts.add(text(end, content));
            }
          });
      return texts;
    }

    Text text(String end, byte[] content) {
      return new Text(
          String.valueOf(names.get(end)), new String(content, StandardCharsets.ISO_8859_1));
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
   * @throws KrlFileException if its files have errors or have been deleted
   */
  String prepare(String name) throws KrlFileException {
    synchronized (parsing) {
      parseAll();
    }
    return prepareParsed(name);
  }

  /** Parses new and changed files, which takes long. */
  private void parseAll() {
    Map<String, Module> found;
    Map<String, Module> known;
    try {
      found = modules();
    } catch (IOException e) {
      return; // reported when they are loaded
    }
    synchronized (this) {
      known = Map.copyOf(loaded);
    }
    Map<Text, ParseResult> results = new HashMap<>();
    found.forEach(
        (key, module) -> {
          Module old = known.get(key);
          if (old == null || !old.isSame(module)) {
            module.texts().forEach(text -> results.put(text, parse(text)));
          }
        });
    synchronized (this) {
      parsed.clear();
      parsed.putAll(results);
    }
  }

  /** Parses a file; a failure of the parser is an error of the file. */
  private static ParseResult parse(Text text) {
    try {
      return KrlParser.parse(text.file, text.text);
    } catch (RuntimeException | VirtualMachineError e) {
      log.warn("{} cannot be parsed", text.file, e);
      return new ParseResult(
          Optional.empty(), error(text.file, "the file cannot be parsed: " + e).errors());
    }
  }

  private synchronized String prepareParsed(String name) throws KrlFileException {
    String key = key(name);
    Map<String, Module> found;
    try {
      found = modules();
    } catch (IOException e) {
      throw error(name, "the files cannot be read: " + e.getMessage());
    }
    for (Map.Entry<String, Module> entry : found.entrySet()) {
      Module old = loaded.get(entry.getKey());
      if (old == null || !old.isSame(entry.getValue())) {
        entry.getValue().hadProgram =
            entry.getValue().hasProgram() || (old != null && old.hadProgram);
        load(entry.getKey(), entry.getValue());
        loaded.put(entry.getKey(), entry.getValue());
      }
    }
    parsed.clear();
    Module module = loaded.get(key);
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

  /**
   * Shows a module loaded from elsewhere as a file, which is not loaded again.
   *
   * @param ending src, sub or dat
   */
  synchronized void show(String name, String ending, String text) {
    if (!files.isInMemory() || name.startsWith("$")) {
      return;
    }
    byte[] content = text.getBytes(StandardCharsets.ISO_8859_1);
    String file = name + "." + ending;
    try {
      files.put("/R1/" + file, content);
    } catch (IOException e) {
      log.debug("{} is not shown as a file: {}", file, e.getMessage());
      return;
    }
    // parts that a client has changed are not loaded yet, so they keep their old state
    Module module = new Module();
    Module old = loaded.get(key(file));
    if (old != null) {
      module.parts.putAll(old.parts);
      module.names.putAll(old.names);
    }
    module.name = name;
    module.parts.put(ending, content);
    module.names.put(ending, file);
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

  /** Reads all modules; if several folders have a file of the same name, the first is used. */
  private Map<String, Module> modules() throws IOException {
    List<FileItem> items = new ArrayList<>(files.modules());
    // data lists are loaded before their programs
    items.sort((a, b) -> Boolean.compare(!isList(a), !isList(b)));
    Map<String, Module> modules = new LinkedHashMap<>();
    for (FileItem item : items) {
      Module module = modules.computeIfAbsent(key(item.path().name()), key -> new Module());
      String end = end(item);
      if (!module.parts.containsKey(end)) {
        module.names.put(end, item.path().name());
        try {
          module.parts.put(end, files.read(item.path().fullName()));
        } catch (IOException e) {
          // the other modules can be loaded
          String reason = "the file cannot be read: " + e.getMessage();
          module.unreadable = error(item.path().name(), reason).errors().get(0);
        }
      }
    }
    return modules;
  }

  private static boolean isList(FileItem item) {
    return end(item).equals("dat");
  }

  private static String end(FileItem item) {
    String name = item.path().name();
    return name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
  }

  private void load(String key, Module module) {
    module.name = key;
    List<KrlError> errors = new ArrayList<>();
    boolean program = module.hasProgram();
    if (module.unreadable != null) {
      errors.add(module.unreadable);
    }
    module.parts.forEach(
        (end, content) -> {
          Text text = module.text(end, content);
          try {
            ModuleLoader.checkLength(text.file, content.length);
            ParseResult result = parsed.get(text);
            if (result == null) {
              result = parse(text);
            }
            // a new list applies to the module of a loaded program, with errors until the new
            // program is loaded too
            boolean followed = program && end.equals("dat");
            errors.addAll(load(module, text, result, followed));
          } catch (KrlFileException e) {
            errors.addAll(e.errors());
          }
        });
    module.errors = List.copyOf(errors);
  }

  /** Loads a file; returns the errors. A failure of the loader is an error of the file. */
  private List<KrlError> load(Module module, Text text, ParseResult result, boolean followed) {
    try {
      module.name = loader.take(text.file, result);
      return List.of();
    } catch (KrlFileException e) {
      return followed ? result.errors() : e.errors();
    } catch (RuntimeException | VirtualMachineError e) {
      log.warn("{} cannot be loaded", text.file, e);
      return error(text.file, "the file cannot be loaded: " + e).errors();
    }
  }
}
