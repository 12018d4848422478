package no.hials.crosscom.simulator;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.KrlFile;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.ParseResult;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.SourceFile;
import no.hials.crosscom.simulator.internal.core.ControllerCore;
import no.hials.crosscom.simulator.internal.core.RobotData;
import no.hials.crosscom.simulator.internal.data.DataLists;
import org.jspecify.annotations.Nullable;

/** Loads data lists and programs into the controller. Thread-safe. */
final class ModuleLoader {
  /**
   * The largest file that is loaded, so that a file that is not a program cannot fill the memory;
   * assumed.
   */
  static final int MAX_LENGTH = 4 << 20;

  /** Called after a file was loaded, without a lock of the controller. */
  @FunctionalInterface
  interface LoadListener {
    void loaded(String module, String extension, String text);
  }

  private final ControllerCore core;
  private final VariableTable variables;
  private volatile LoadListener listener = (module, ending, text) -> {};

  /** Data lists of modules, by name in upper case; guarded by the core. */
  private final Map<String, DataList> dataLists = new HashMap<>();

  ModuleLoader(ControllerCore core, VariableTable variables) {
    this.core = core;
    this.variables = variables;
  }

  void listener(LoadListener loaded) {
    listener = loaded;
  }

  String load(Path file) throws IOException, KrlFileException {
    String name = String.valueOf(file.getFileName());
    String text = text(file);
    Path list = dataListOf(file);
    if (list == null) {
      return load(name, text);
    }
    String listText = text(list);
    ParseResult data = parse(String.valueOf(list.getFileName()), listText);
    KrlFile module = take(name, parse(name, text), data);
    listener.loaded(module.name(), "dat", listText);
    tell(module, name, text);
    return module.name();
  }

  private static String text(Path file) throws IOException, KrlFileException {
    if (!Files.exists(file)) {
      throw new NoSuchFileException(file.toString(), null, "there is no such file");
    }
    checkLength(String.valueOf(file.getFileName()), Files.size(file));
    return Files.readString(file, StandardCharsets.ISO_8859_1);
  }

  /** Checks the length of a file before it is parsed, because trees are much larger than texts. */
  static void checkLength(String fileName, long bytes) throws KrlFileException {
    if (bytes > MAX_LENGTH) {
      throw new KrlFileException(
          List.of(
              new KrlError(
                  new Position(fileName, 1, 1),
                  "a file of KRL has at most " + MAX_LENGTH + " bytes, has " + bytes)));
    }
  }

  private static ParseResult parse(String fileName, String text) throws KrlFileException {
    checkLength(fileName, text.length());
    return KrlParser.parse(fileName, text);
  }

  /** Finds the data list of a source file; another case counts only if no other file matches. */
  private static @Nullable Path dataListOf(Path file) throws IOException {
    String name = String.valueOf(file.getFileName());
    int dot = name.lastIndexOf('.');
    Path folder = file.toAbsolutePath().getParent();
    if (dot < 0 || folder == null || name.substring(dot).equalsIgnoreCase(".dat")) {
      return null;
    }
    boolean capitals = name.endsWith(".SRC") || name.endsWith(".SUB");
    String wanted = name.substring(0, dot) + (capitals ? ".DAT" : ".dat");
    try (Stream<Path> files = Files.list(folder)) {
      List<String> found =
          files
              .map(other -> String.valueOf(other.getFileName()))
              .filter(wanted::equalsIgnoreCase)
              .sorted()
              .toList();
      if (found.size() > 1 && !found.contains(wanted)) {
        throw new IOException("it has several data lists: " + String.join(", ", found));
      }
      return found.isEmpty()
          ? null
          : folder.resolve(found.contains(wanted) ? wanted : found.get(0));
    }
  }

  String load(String fileName, String text) throws KrlFileException {
    KrlFile file = take(fileName, parse(fileName, text), null);
    tell(file, fileName, text);
    return file.name();
  }

  /** Loads a parsed file as {@link #load(String, String)} does, without calling the listener. */
  String take(String fileName, ParseResult parsed) throws KrlFileException {
    return take(fileName, parsed, null).name();
  }

  private void tell(KrlFile file, String fileName, String text) {
    boolean submit = fileName.toLowerCase(Locale.ROOT).endsWith(".sub");
    String ending = submit ? "sub" : "src";
    listener.loaded(file.name(), file instanceof DataList ? "dat" : ending, text);
  }

  private KrlFile take(String fileName, ParseResult parsed, @Nullable ParseResult parsedList)
      throws KrlFileException {
    List<KrlError> errors = new ArrayList<>(parsed.errors());
    if (parsedList != null) {
      errors.addAll(parsedList.errors());
    }
    KrlFile file = parsed.file().orElse(null);
    if (!errors.isEmpty() || file == null) {
      throw new KrlFileException(errors);
    }
    if (file instanceof SourceFile source) {
      takeSource(source, parsedList);
    } else {
      takeData(fileName, (DataList) file, parsed);
    }
    return file;
  }

  private void takeSource(SourceFile source, @Nullable ParseResult parsedList)
      throws KrlFileException {
    List<KrlError> errors =
        core.withLibrary(
            library -> {
              DataList data = dataLists.get(key(source.name()));
              if (parsedList != null && parsedList.file().orElse(null) instanceof DataList list) {
                data = list;
              }
              List<KrlError> found = library.put(source, data);
              if (found.isEmpty() && data != null) {
                dataLists.put(key(source.name()), data);
              }
              return found;
            });
    if (!errors.isEmpty()) {
      throw new KrlFileException(errors);
    }
  }

  private void takeData(String fileName, DataList list, ParseResult parsed)
      throws KrlFileException {
    // of a module's list this publishes the global declarations, and reports the errors
    variables.load(fileName, parsed);
    core.loaded(new RobotData(DataLists.set(list, RobotData.SIGNS), variables.robotData()));
    if (!list.name().startsWith("$")) {
      core.withLibrary(
          library -> {
            dataLists.put(key(list.name()), list);
            return library.put(list);
          });
    }
  }

  private static String key(String name) {
    return name.toUpperCase(Locale.ROOT);
  }
}
