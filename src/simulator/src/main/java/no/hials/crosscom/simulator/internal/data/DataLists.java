package no.hials.crosscom.simulator.internal.data;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.Declaration;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.KrlFile;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.ParseResult;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.lang.VariableNote;
import no.hials.crosscom.protocol.value.KrlEncoding;
import no.hials.crosscom.simulator.VariableInfo;

/** Reads, writes and names the files of data lists. */
public final class DataLists {
  /** The maximum length of a name (docs/reference/krl-values.md#names). */
  private static final int MAX_NAME_LENGTH = 24;

  private static final TypeSwitch<NoteCollector, Declaration, Void, RuntimeException> NOTES =
      TypeSwitch.create(
          Declaration.class,
          cases ->
              cases
                  .run(Declaration.Variables.class, NoteCollector::add)
                  .run(Declaration.Signal.class, NoteCollector::add)
                  .run(Declaration.StrucDeclaration.class, DataLists::isNoVariable)
                  .run(Declaration.EnumDeclaration.class, DataLists::isNoVariable)
                  .run(Declaration.Channel.class, DataLists::isNoVariable)
                  .run(Declaration.InitialValue.class, DataLists::isNoVariable)
                  .run(Declaration.External.class, DataLists::isNoVariable));

  /** Adds the names of the variables that a declaration sets. */
  private static final TypeSwitch<Set<String>, Declaration, Void, RuntimeException> SET =
      TypeSwitch.create(
          Declaration.class,
          cases ->
              cases
                  .run(
                      Declaration.Variables.class,
                      (names, group) ->
                          group.variables().forEach(one -> names.add(Scope.key(one.name()))))
                  .run(
                      Declaration.InitialValue.class,
                      (names, value) -> names.add(Scope.key(value.target().name())))
                  .run(Declaration.Signal.class, DataLists::isNoVariable)
                  .run(Declaration.StrucDeclaration.class, DataLists::isNoVariable)
                  .run(Declaration.EnumDeclaration.class, DataLists::isNoVariable)
                  .run(Declaration.Channel.class, DataLists::isNoVariable)
                  .run(Declaration.External.class, DataLists::isNoVariable));

  private static final Pattern ELEMENT = Pattern.compile("^[^.\\[]*\\[(\\d+)]");

  private DataLists() {}

  /** The case of a declaration that declares no variable with a note or a value. */
  private static void isNoVariable(Object context, Declaration declaration) {}

  /** Collects the notes on the global variables of a list. */
  private record NoteCollector(DataList list, Map<String, VariableNote> notes) {
    void add(Declaration.Variables group) {
      if (isGlobal(list, group.global())) {
        VariableNote note = VariableNote.of(group.comment());
        group.variables().forEach(variable -> notes.put(Scope.key(variable.name()), note));
      }
    }

    void add(Declaration.Signal signal) {
      if (isGlobal(list, signal.global())) {
        notes.put(Scope.key(signal.name()), VariableNote.of(signal.comment()));
      }
    }
  }

  /**
   * Parses a file in Windows-1252 or UTF-8.
   *
   * @throws IOException if the file does not exist or cannot be read
   */
  public static ParseResult parse(java.nio.file.Path file) throws IOException {
    if (Files.isDirectory(file)) {
      throw new FileSystemException(
          file.toString(), null, "a data list is a file, this is a directory");
    }
    if (!Files.exists(file)) {
      throw new NoSuchFileException(file.toString(), null, "the data list does not exist");
    }
    return KrlParser.parse(file);
  }

  /**
   * Writes a file in Windows-1252, or in UTF-8 if a character requires it.
   *
   * @throws IOException if the file cannot be written
   */
  public static void write(java.nio.file.Path file, String text) throws IOException {
    Files.write(file, KrlEncoding.encode(text));
  }

  /**
   * Returns the data list of a parsed file.
   *
   * @param fileName the name in messages
   * @param errors gets the errors
   * @return empty if the file is not a data list, which is then one of the errors
   */
  public static Optional<DataList> dataList(
      String fileName, ParseResult result, List<KrlError> errors) {
    KrlFile file = result.file().orElse(null);
    if (file instanceof DataList list) {
      errors.addAll(result.errors());
      return Optional.of(list);
    }
    if (file != null) {
      // its errors as a program do not matter
      errors.add(
          new KrlError(
              file.position(), "a data list begins with DEFDAT, found the program " + file.name()));
    } else if (result.errors().isEmpty()) {
      errors.add(
          new KrlError(
              new Position(fileName, 1, 1), "a data list begins with DEFDAT, found nothing"));
    } else {
      errors.addAll(result.errors());
    }
    return Optional.empty();
  }

  /** Returns the errors of one file in the order of the file. */
  public static List<KrlError> sorted(List<KrlError> errors) {
    List<KrlError> sorted = new ArrayList<>(errors);
    sorted.sort(
        Comparator.comparingInt((KrlError error) -> error.position().line())
            .thenComparingInt(error -> error.position().column()));
    return sorted;
  }

  /**
   * Returns the notes in the comments of a data list on its global variables, by the names of the
   * variables in upper case.
   */
  public static Map<String, VariableNote> notes(DataList list) {
    Map<String, VariableNote> notes = new HashMap<>();
    if (isGlobal(list, true)) {
      NoteCollector collector = new NoteCollector(list, notes);
      list.declarations().forEach(declaration -> NOTES.run(collector, declaration));
    }
    return notes;
  }

  /** Returns which of some variables, in upper case, a list of the controller itself sets. */
  public static Set<String> variablesSetBy(DataList list, Set<String> variables) {
    Set<String> found = new HashSet<>();
    if (DataListLoader.isSystem(list)) {
      list.declarations().forEach(declaration -> SET.run(found, declaration));
    }
    found.retainAll(variables);
    return found;
  }

  /**
   * Returns where a list last sets a variable, or an element of it.
   *
   * @param variable such as {@code $DH_5.DHART_A} or {@code $SOFTN_END[2]}
   * @return the place of the list if the variable is not in it
   */
  public static Position place(DataList list, String variable) {
    String name = Scope.key(variable.replaceFirst("[.\\[].*", ""));
    Matcher element = ELEMENT.matcher(variable);
    String index = element.find() ? element.group(1) : "";
    Position place = list.position();
    for (Declaration declaration : list.declarations()) {
      Set<String> names = new HashSet<>();
      SET.run(names, declaration);
      if (names.contains(name) && (index.isEmpty() || isOf(declaration, index))) {
        place = declaration.position();
      }
    }
    return place;
  }

  /** Returns whether a declaration sets an element, or the whole array. */
  private static boolean isOf(Declaration declaration, String index) {
    if (!(declaration instanceof Declaration.InitialValue value)) {
      return true;
    }
    List<Expression> indices = value.target().steps().get(0).indices();
    return indices.isEmpty()
        || (indices.get(0) instanceof Expression.IntLiteral number
            && String.valueOf(number.value()).equals(index));
  }

  /**
   * Describes a variable, in a scope or around it.
   *
   * @param name its name in any case, without index
   * @param notes the notes of the variables, by their names in upper case
   */
  public static Optional<VariableInfo> describe(
      Scope scope, String name, Map<String, VariableNote> notes) {
    VariableEntry variable = scope.lookup(Scope.key(name));
    if (variable == null) {
      return Optional.empty();
    }
    VariableNote note = notes.getOrDefault(Scope.key(name), VariableNote.NONE);
    Storage contents = variable.contents();
    DeclaredType type = contents == null ? null : DeclaredType.of(contents);
    return Optional.of(
        new VariableInfo(
            variable.name(),
            type == null ? "SIGNAL" : type.element().name(),
            type == null ? List.of() : type.dimensions(),
            variable.access(),
            note.unit(),
            note.meaning(),
            note.source()));
  }

  private static boolean isGlobal(DataList list, boolean global) {
    return DataListLoader.isSystem(list) || (global && list.isPublic());
  }

  /**
   * Returns the name of a system data list, such as {@code $STATE} for {@code state.dat}.
   *
   * @param text a name with or without {@code $}, or the name of a file
   */
  public static String systemName(String text) {
    String name = text.replaceFirst("\\.[^.]*$", "").toUpperCase(Locale.ROOT);
    name = name.replaceAll("[^A-Z0-9_$]", "_");
    name = name.startsWith("$") ? name : "$" + name;
    return name.substring(0, Math.min(name.length(), MAX_NAME_LENGTH));
  }
}
