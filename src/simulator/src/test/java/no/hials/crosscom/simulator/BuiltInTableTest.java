package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.Declaration;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.ParseResult;
import no.hials.crosscom.lang.VariableNote;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.internal.data.BuiltInDataLists;
import no.hials.crosscom.simulator.internal.data.ConstantExpressions;
import no.hials.crosscom.simulator.internal.data.KrlErrorException;
import no.hials.crosscom.simulator.internal.data.Scope;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** Goes through the rows of the table that the server starts with. */
class BuiltInTableTest {
  private static final Set<String> BASE_TYPES = Set.of("INT", "REAL", "BOOL");
  private static final Path TYPES_PAGE = Path.of("..", "..", "docs", "reference", "krl-types.md");

  private final VariableTable table = VariableTable.krc4();

  /** A declaration of a variable. */
  private record Row(
      String name, String type, int dimensions, @Nullable String value, VariableNote note) {

    /** Returns a name under which the row's value, or the first element of it, can be read. */
    String readName(boolean isStruc) {
      if (dimensions == 0) {
        return name;
      }
      if (type.equals("CHAR")) {
        return name + (dimensions > 1 ? "[1,]" : "[]");
      }
      return name + (isStruc ? "[1]" : "[]");
    }
  }

  private static List<Declaration> declarations() {
    List<Declaration> declarations = new ArrayList<>();
    for (String file : BuiltInDataLists.NAMES) {
      ParseResult result = KrlParser.parse(file, text(file));
      assertThat(result.errors()).isEmpty();
      declarations.addAll(((DataList) result.file().orElseThrow()).declarations());
    }
    return declarations;
  }

  private static String text(String file) {
    try {
      return BuiltInDataLists.text(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static List<Row> rows() {
    Set<String> withElements = new HashSet<>();
    List<Declaration> declarations = declarations();
    for (Declaration declaration : declarations) {
      if (declaration instanceof Declaration.InitialValue initial) {
        withElements.add(initial.target().name());
      }
    }
    List<Row> rows = new ArrayList<>();
    for (Declaration declaration : declarations) {
      if (declaration instanceof Declaration.Signal signal) {
        rows.add(new Row(signal.name(), "SIGNAL", 0, "", VariableNote.of(signal.comment())));
      } else if (declaration instanceof Declaration.Variables group) {
        VariableNote note = VariableNote.of(group.comment());
        for (Declaration.Declarator variable : group.variables()) {
          String value = withElements.contains(variable.name()) ? "" : text(variable.initial());
          rows.add(
              new Row(variable.name(), group.type(), variable.dimensions().size(), value, note));
        }
      }
    }
    return rows;
  }

  /** Returns the KRL text of an initial value; null without one. */
  private static @Nullable String text(@Nullable Expression initial) {
    try {
      return initial == null
          ? null
          : ConstantExpressions.evaluate(initial, new Scope()).printShort();
    } catch (KrlErrorException e) {
      throw new AssertionError(e.getMessage(), e);
    }
  }

  private static Set<String> strucs() {
    Set<String> strucs = new HashSet<>();
    for (Declaration declaration : declarations()) {
      if (declaration instanceof Declaration.StrucDeclaration struc) {
        strucs.add(struc.name());
      }
    }
    return strucs;
  }

  @Test
  void hasMoreThan250Variables() {
    assertThat(table.names()).hasSizeGreaterThan(250).hasSameSizeAs(rows());
  }

  @Test
  void saysWhichDataListIsWrongOrMissing() {
    assertThatThrownBy(() -> BuiltInTable.load(List.of("user-config.dat")))
        .isInstanceOf(IllegalStateException.class)
        .hasMessageStartingWith("a data list in the jar is wrong: user-config.dat:");
    assertThatThrownBy(() -> BuiltInTable.load(List.of("$NONE.DAT")))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("a data list in the jar is wrong: resource $NONE.DAT is missing");
  }

  @Test
  void saysOfEveryVariableWhatItIsAndWhereThatIsKnownFrom() {
    for (Row row : rows()) {
      VariableInfo info = table.describe(row.name()).orElseThrow();
      assertThat(row.note().access()).as(row.name()).isNotNull().isEqualTo(info.access());
      assertThat(info.type()).as(row.name()).isEqualTo(row.type());
      assertThat(info.dimensions()).as(row.name()).hasSize(row.dimensions());
      assertThat(info.unit()).as(row.name()).isEqualTo(row.note().unit());
      assertThat(info.meaning()).as(row.name()).isNotBlank();
      assertThat(info.source()).as(row.name()).isNotBlank();
    }
    assertThat(table.describeAll()).hasSameSizeAs(rows());
  }

  @Test
  void saysOfEveryTypeWhereItIsKnownFrom() {
    for (Declaration declaration : declarations()) {
      if (declaration instanceof Declaration.StrucDeclaration struc) {
        assertThat(struc.comment()).as(struc.name()).matches("\\([A-Z0-9a-z ]+\\)");
      } else if (declaration instanceof Declaration.EnumDeclaration enumeration) {
        assertThat(enumeration.comment()).as(enumeration.name()).matches("\\([A-Z0-9a-z ]+\\)");
      }
    }
  }

  @Test
  void hasTheTypesOfKssThatTheReferenceLists() throws IOException {
    List<String> listed = new ArrayList<>();
    for (String line : Files.readAllLines(TYPES_PAGE)) {
      if (line.startsWith("| STRUC |") || line.startsWith("| ENUM |")) {
        String[] cells = line.replace(", ", ",").split("\\|", -1);
        listed.add(
            String.join(
                " ", cells[1].strip(), cells[2].strip().replace("`", ""), cells[3].strip()));
      }
    }
    List<String> declared =
        text("$TYPES.DAT")
            .lines()
            .filter(line -> line.endsWith(" ;(KSS)"))
            .map(line -> line.substring(0, line.indexOf(" ;")))
            .sorted()
            .toList();

    assertThat(listed).hasSizeGreaterThan(150).containsExactlyInAnyOrderElementsOf(declared);
    assertThat(listed)
        .allSatisfy(row -> assertThat(table.scope().knowsType(row.split(" ", -1)[1])).isTrue());
  }

  @Test
  void isTheSameAgainWhenItsListIsLoadedIntoAnEmptyTable() throws KrlFileException {
    VariableTable loaded = VariableTable.empty();
    loaded.load("state", table.toDataList("STATE"));
    assertThat(loaded.describeAll()).isEqualTo(table.describeAll());
    for (Row row : rows()) {
      assertThat(values(loaded, row)).as(row.name()).isEqualTo(values(table, row));
    }
    assertThat(loaded.toDataList("STATE")).isEqualTo(table.toDataList("STATE"));
  }

  /** Reads every element, or says why it cannot be read. */
  private List<String> values(VariableTable from, Row row) {
    List<Integer> dimensions = from.describe(row.name()).orElseThrow().dimensions();
    boolean isText = row.type().equals("CHAR") && !dimensions.isEmpty();
    if (dimensions.isEmpty() || (isText && dimensions.size() == 1)) {
      return List.of(value(from, isText ? row.name() + "[]" : row.name()));
    }
    List<String> values = new ArrayList<>();
    for (int i = 1; i <= dimensions.get(0); i++) {
      values.add(value(from, row.name() + "[" + i + (isText ? ",]" : "]")));
    }
    return values;
  }

  private static String value(VariableTable from, String name) {
    try {
      return from.read(name);
    } catch (RefusedException e) {
      return e.reason() + " " + e.getMessage();
    }
  }

  @Test
  void readsEveryRowOrSaysThatItHasNoValue() throws RefusedException {
    Set<String> strucs = strucs();
    for (Row row : rows()) {
      boolean isStruc = strucs.contains(row.type());
      String name = row.readName(isStruc);
      if (row.value() == null && !isStruc) {
        RefusedException e = catchThrowableOfType(RefusedException.class, () -> table.read(name));
        assertThat(e).as(name).isNotNull();
        assertThat(e.reason()).as(name).isEqualTo(Refusal.NOT_INITIALISED);
        continue;
      }
      String text = table.read(name);
      assertThat(KrlValue.parse(text).print()).as(name).isEqualTo(text);
      if (isStruc) {
        assertThat(text).as(name).startsWith("{" + row.type() + ": ");
      } else if (row.type().equals("SIGNAL")) {
        assertThat(text).as(name).isIn("TRUE", "FALSE");
      } else if (row.type().equals("CHAR")) {
        assertThat(text).as(name).startsWith("\"").endsWith("\"");
      } else if (!BASE_TYPES.contains(row.type())) {
        assertThat(text).as(name).startsWith("#");
      }
    }
  }

  @Test
  void holdsTheValuesOfTheRows() throws RefusedException {
    for (Row row : rows()) {
      String value = row.value();
      if (row.dimensions() > 0 || value == null || row.type().equals("SIGNAL")) {
        continue;
      }
      KrlValue declared = KrlValue.parse(value);
      KrlValue held = table.readValue(row.name());
      if (declared instanceof KrlStruct struct) {
        for (KrlStruct.Field field : struct.fields()) {
          if (!(field.value() instanceof KrlStruct)) {
            assertThat(((KrlStruct) held).get(field.name()))
                .as(row.name() + "." + field.name())
                .contains(field.value());
          }
        }
      } else {
        assertThat(held).as(row.name()).isEqualTo(declared);
      }
    }
  }

  @Test
  void takesBackEveryRowThatClientsMayWriteAndRefusesTheOthers() throws RefusedException {
    Set<String> strucs = strucs();
    for (Row row : rows()) {
      boolean isStruc = strucs.contains(row.type());
      String name = row.readName(isStruc);
      if (row.value() == null && !isStruc) {
        continue;
      }
      if (row.note().access() == Access.READ_WRITE
          && name.endsWith("[]")
          && !row.type().equals("CHAR")) {
        name = row.name() + "[1]";
      }
      String target = name;
      String text = table.read(target);
      if (row.note().access() == Access.READ_WRITE) {
        table.write(target, text, 0);
        assertThat(table.read(target)).as(target).isEqualTo(text);
      } else {
        RefusedException e =
            catchThrowableOfType(RefusedException.class, () -> table.write(target, text, 0));
        assertThat(e).as(target).isNotNull();
        assertThat(e.reason()).as(target).isEqualTo(Refusal.READ_ONLY);
      }
    }
  }

  @Test
  void standsAtHomeInT1() {
    assertThat(table.get("$MODE_OP")).isEqualTo("#T1");
    assertThat(table.get("$T1")).isEqualTo("TRUE");
    assertThat(table.get("$AUT")).isEqualTo("FALSE");
    assertThat(table.get("$ROB_STOPPED")).isEqualTo("TRUE");
    assertThat(table.get("$PERI_RDY")).isEqualTo("FALSE");
    assertThat(table.get("$PRO_STATE1")).isEqualTo("#P_FREE");
    assertThat(table.get("$AXIS_ACT.A2")).isEqualTo("-90.0000");
    assertThat(table.get("$RAT_MOT_AX[6]")).isEqualTo("{FRA: N 520960, D 8901}");
  }
}
