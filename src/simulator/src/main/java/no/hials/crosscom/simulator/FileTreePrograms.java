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
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.simulator.internal.files.ControllerFileSystem;
import no.hials.crosscom.simulator.internal.files.FileItem;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Brings the programs and data lists of the file tree into the controller when one of them is to be
 * selected: all that are new or have changed, as one may call another. What a file had is not taken
 * away when it is deleted, but its program cannot be selected any more.
 *
 * <p>The lists of the controller, {@code $config.dat} and the like, are loaded when they have
 * changed since this was made; that a change counts from the next selection on is assumed.
 *
 * <p>Thread-safe.
 */
final class FileTreePrograms {
  private static final Logger log = LoggerFactory.getLogger(FileTreePrograms.class);

  /** So that a text that is no program cannot fill the memory; assumed. */
  private static final int MAX_LENGTH = 4 << 20;

  private final ControllerFileSystem files;
  private final Controller controller;

  /** What each module was loaded from, by its file's name in capital letters without the end. */
  private final Map<String, Module> loaded = new HashMap<>();

  FileTreePrograms(FileTree files, Controller controller) {
    this.files = ControllerFileSystem.of(files);
    this.controller = controller;
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
    /** Their content by their end, in lower case; the data list comes first. */
    private final Map<String, byte[]> parts = new LinkedHashMap<>();

    private final Map<String, String> names = new HashMap<>();

    /** What is wrong; empty if it could be loaded. */
    private List<KrlError> errors = List.of();

    /** The module's name, which may be another than its file's. */
    private String name = "";

    /** Whether it has a program, or had one that was deleted since. */
    private boolean hadProgram;

    boolean hasProgram() {
      return parts.keySet().stream().anyMatch(end -> !end.equals("dat"));
    }

    boolean isSame(Module other) {
      return parts.keySet().equals(other.parts.keySet())
          && parts.keySet().stream()
              .allMatch(end -> Arrays.equals(parts.get(end), other.parts.get(end)));
    }
  }

  /**
   * Loads what is new, and finds the module that a client means.
   *
   * @param name such as {@code /R1/X.SRC}, {@code /R1/X()}, {@code KRC:\R1\PROGRAM\X.SRC} or {@code
   *     X}, in any case
   * @return the name to select it by; that of a module that only the controller knows is given back
   *     as it is, without folders and end
   * @throws KrlFileException if its files have errors, or are there no more
   */
  synchronized String prepare(String name) throws KrlFileException {
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
    Module module = loaded.get(key);
    if (module == null) {
      return key;
    }
    // what is left of it may be its data list only
    if (!found.containsKey(key) || (module.hadProgram && !module.hasProgram())) {
      throw error(name, "the files of " + key + " are not there any more");
    }
    if (!module.errors.isEmpty()) {
      throw new KrlFileException(module.errors);
    }
    return module.name;
  }

  /**
   * Shows the file of a module that somebody else has loaded; it need not be loaded any more.
   *
   * @param name the module's name
   * @param ending src, sub or dat
   * @param text the contents
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
    // another part that a client has changed is still to be loaded, so it stays as it was known
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

  /** Takes the name of a module from the forms in which clients write it. */
  private static String key(String name) {
    String bare = name.strip();
    bare = bare.substring(Math.max(bare.lastIndexOf('/'), bare.lastIndexOf('\\')) + 1);
    int brace = bare.indexOf('(');
    bare = brace < 0 ? bare : bare.substring(0, brace).strip();
    int dot = bare.lastIndexOf('.');
    return (dot < 0 ? bare : bare.substring(0, dot)).toUpperCase(Locale.ROOT);
  }

  /** Reads all modules; of files of the same name in several folders the first one counts. */
  private Map<String, Module> modules() throws IOException {
    List<FileItem> items = new ArrayList<>(files.modules());
    // a data list belongs before its program
    items.sort((a, b) -> Boolean.compare(!isList(a), !isList(b)));
    Map<String, Module> modules = new LinkedHashMap<>();
    for (FileItem item : items) {
      Module module = modules.computeIfAbsent(key(item.path().name()), key -> new Module());
      String end = end(item);
      if (!module.parts.containsKey(end)) {
        module.parts.put(end, files.read(item.path().fullName()));
        module.names.put(end, item.path().name());
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
    module.parts.forEach(
        (end, content) -> {
          String file = String.valueOf(module.names.get(end));
          if (content.length > MAX_LENGTH) {
            errors.addAll(
                error(file, "a file of KRL has at most " + MAX_LENGTH + " bytes").errors());
            return;
          }
          String text = new String(content, StandardCharsets.ISO_8859_1);
          try {
            module.name = controller.take(file, text);
          } catch (KrlFileException e) {
            // a new list of a program that is loaded is taken, but refused until that is, too
            boolean followed = program && end.equals("dat");
            errors.addAll(followed ? KrlParser.parse(file, text).errors() : e.errors());
          }
        });
    module.errors = List.copyOf(errors);
  }
}
