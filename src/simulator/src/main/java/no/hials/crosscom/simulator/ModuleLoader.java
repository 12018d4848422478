package no.hials.crosscom.simulator;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.KrlFile;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.ParseResult;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.SourceFile;
import no.hials.crosscom.protocol.value.KrlEncoding;
import no.hials.crosscom.simulator.LoadReport.FileReport;
import no.hials.crosscom.simulator.internal.core.ControllerCore;
import no.hials.crosscom.simulator.internal.core.RobotData;
import no.hials.crosscom.simulator.internal.data.DataLists;
import org.jspecify.annotations.Nullable;

/** Loads data lists and programs into the controller. Thread-safe. */
final class ModuleLoader {
  /**
   * The largest file of the user that is loaded: a program of 20 MB with the points of a CAM system
   * fits. What clients write has a lower limit, {@link FileTreePrograms#MAX_LENGTH}; assumed.
   */
  static final int MAX_LENGTH = 32 << 20;

  /** Called after a file was loaded, without a lock of the controller. */
  @FunctionalInterface
  interface LoadListener {
    void loaded(String module, String extension, byte[] content);
  }

  private final ControllerCore core;
  private final VariableTable variables;
  private volatile LoadListener listener = (module, ending, content) -> {};

  /** Data lists of modules, by name in upper case; guarded by the core. */
  private final Map<String, DataList> dataLists = new HashMap<>();

  ModuleLoader(ControllerCore core, VariableTable variables) {
    this.core = core;
    this.variables = variables;
  }

  void listener(LoadListener loaded) {
    listener = loaded;
  }

  /**
   * A loaded file, and the data list loaded with it.
   *
   * @param module the program or data list; null if it was refused
   * @param report the results of both
   */
  record Loaded(@Nullable KrlFile module, LoadReport report) {
    /** Returns the name of the module. */
    String name() throws KrlFileException {
      if (module == null) {
        throw new KrlFileException(report.problems());
      }
      return module.name();
    }
  }

  /** A file to load: its name, the bytes to show as a file, and its tree. */
  @SuppressWarnings("ArrayRecordComponent") // never compared
  private record Input(String fileName, byte[] content, ParseResult parsed) {
    private static final byte[] NOTHING = {};

    static Input of(String fileName, String text) {
      try {
        return of(fileName, text, KrlEncoding.encode(text));
      } catch (CharacterCodingException e) {
        return of(fileName, text, text.getBytes(StandardCharsets.UTF_8));
      }
    }

    private static Input of(String fileName, String text, byte[] content) {
      List<KrlError> tooLong = tooLong(fileName, content.length, MAX_LENGTH);
      return new Input(
          fileName,
          content,
          tooLong.isEmpty()
              ? KrlParser.parse(fileName, text)
              : new ParseResult(Optional.empty(), tooLong));
    }

    static Input of(Path file) throws IOException {
      if (!Files.exists(file)) {
        throw new NoSuchFileException(file.toString(), null, "there is no such file");
      }
      String name = String.valueOf(file.getFileName());
      List<KrlError> tooLong = tooLong(name, Files.size(file), MAX_LENGTH);
      if (!tooLong.isEmpty()) {
        return new Input(name, NOTHING, new ParseResult(Optional.empty(), tooLong));
      }
      byte[] content = Files.readAllBytes(file);
      return of(name, KrlEncoding.decode(content), content);
    }
  }

  Loaded load(Path file, LoadingMode mode) throws IOException {
    Input input = Input.of(file);
    Path list = dataListOf(file);
    return load(input, list == null ? null : Input.of(list), mode);
  }

  Loaded load(String fileName, String text, LoadingMode mode) {
    return load(Input.of(fileName, text), null, mode);
  }

  private Loaded load(Input input, @Nullable Input list, LoadingMode mode) {
    Loaded loaded = take(input, list, mode);
    if (loaded.module() != null) {
      if (list != null && list.parsed().file().isPresent()) {
        listener.loaded(loaded.module().name(), "dat", list.content());
      }
      tell(loaded.module(), input.fileName(), input.content());
    }
    return loaded;
  }

  /**
   * Loads a parsed file as {@link #load(String, String, LoadingMode)} does, without calling the
   * listener.
   */
  Loaded take(String fileName, ParseResult parsed, LoadingMode mode) {
    return take(new Input(fileName, Input.NOTHING, parsed), null, mode);
  }

  /** Checks the length of a file before it is parsed, because its tree takes as much again. */
  static void checkLength(String fileName, long bytes, int limit) throws KrlFileException {
    List<KrlError> errors = tooLong(fileName, bytes, limit);
    if (!errors.isEmpty()) {
      throw new KrlFileException(errors);
    }
  }

  private static List<KrlError> tooLong(String fileName, long bytes, int limit) {
    return bytes <= limit
        ? List.of()
        : List.of(
            new KrlError(
                new Position(fileName, 1, 1),
                "a file of KRL has at most " + limit + " bytes, has " + bytes));
  }

  /** Finds the data list of a source file; another case is used only if no other file matches. */
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

  private void tell(KrlFile file, String fileName, byte[] content) {
    boolean submit = fileName.toLowerCase(Locale.ROOT).endsWith(".sub");
    String ending = submit ? "sub" : "src";
    listener.loaded(file.name(), file instanceof DataList ? "dat" : ending, content);
  }

  private Loaded take(Input input, @Nullable Input list, LoadingMode mode) {
    KrlFile file = input.parsed().file().orElse(null);
    boolean whole =
        input.parsed().errors().isEmpty() && (list == null || list.parsed().errors().isEmpty());
    if (file == null || (mode == LoadingMode.STRICT && !whole)) {
      return refused(input, list);
    }
    return file instanceof SourceFile source
        ? takeSource(source, input, list, mode)
        : takeData((DataList) file, input, mode);
  }

  private static Loaded refused(Input input, @Nullable Input list) {
    List<FileReport> files = new ArrayList<>();
    files.add(FileReport.refused(input.fileName(), input.parsed().errors()));
    if (list != null) {
      files.add(FileReport.refused(list.fileName(), list.parsed().errors()));
    }
    return new Loaded(null, new LoadReport(files));
  }

  private Loaded takeSource(
      SourceFile source, Input input, @Nullable Input list, LoadingMode mode) {
    List<KrlError> ofList = new ArrayList<>();
    Optional<DataList> own =
        list == null
            ? Optional.empty()
            : DataLists.dataList(list.fileName(), list.parsed(), ofList);
    List<KrlError> errors =
        core.withLibrary(
            library -> {
              DataList data = own.orElse(dataLists.get(key(source.name())));
              List<KrlError> found = library.put(source, data, mode);
              if (data != null && (found.isEmpty() || mode == LoadingMode.LENIENT)) {
                dataLists.put(key(source.name()), data);
              }
              return found;
            });
    if (mode == LoadingMode.STRICT && !errors.isEmpty()) {
      // without a file of its own the list was loaded before
      FileReport program = FileReport.refused(input.fileName(), list == null ? errors : List.of());
      return new Loaded(
          null,
          new LoadReport(
              list == null
                  ? List.of(program)
                  : List.of(program, FileReport.refused(list.fileName(), errors))));
    }
    List<FileReport> files = new ArrayList<>();
    files.add(FileReport.loaded(input.fileName(), source.name(), input.parsed().errors()));
    if (list != null) {
      ofList.addAll(errors);
      files.add(
          own.isPresent()
              ? FileReport.loaded(list.fileName(), own.get().name(), DataLists.sorted(ofList))
              : FileReport.refused(list.fileName(), ofList));
    }
    return new Loaded(source, new LoadReport(files));
  }

  private Loaded takeData(DataList list, Input input, LoadingMode mode) {
    // of a module's list this publishes the global declarations, and reports the errors
    LoadReport report = variables.load(input.fileName(), input.parsed(), mode);
    if (report.anyRefused()) {
      return new Loaded(null, report);
    }
    List<RobotData.UnusedData> refusals =
        core.loaded(variables.robotData(DataLists.variablesSetBy(list, RobotData.SIGNS)));
    if (!list.name().startsWith("$")) {
      core.withLibrary(
          library -> {
            dataLists.put(key(list.name()), list);
            return library.put(list, mode);
          });
    }
    return new Loaded(list, withRefusals(report, list, refusals));
  }

  /** Adds the data of the robot that are not used, each at its place in the list. */
  private static LoadReport withRefusals(
      LoadReport report, DataList list, List<RobotData.UnusedData> refusals) {
    if (refusals.isEmpty()) {
      return report;
    }
    FileReport file = report.files().get(0);
    List<KrlError> problems = new ArrayList<>(file.problems());
    refusals.forEach(
        refusal ->
            problems.add(
                new KrlError(DataLists.place(list, refusal.variable()), refusal.reason())));
    return new LoadReport(
        List.of(FileReport.loaded(file.path(), file.module(), DataLists.sorted(problems))));
  }

  private static String key(String name) {
    return name.toUpperCase(Locale.ROOT);
  }
}
