package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import no.hials.crosscom.mock.internal.data.RefusedException;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import org.junit.jupiter.api.Test;

/** Goes through the rows of the table that the server starts with. */
class BuiltInTableTest {
  private static final Set<String> BASE_TYPES = Set.of("INT", "REAL", "BOOL");

  private final VariableTable table = VariableTable.krc4();

  private record Row(String name, String type, String access, String value) {

    String baseName() {
      return name.indexOf('[') < 0 ? name : name.substring(0, name.indexOf('['));
    }

    /** Gives a name under which the row's value, or the first element of it, can be read. */
    String readName(boolean isStruc) {
      if (name.indexOf('[') < 0) {
        return name;
      }
      if (type.equals("CHAR")) {
        return baseName() + (name.contains(",") ? "[1,]" : "[]");
      }
      return baseName() + (isStruc ? "[1]" : "[]");
    }
  }

  /** Gives the rows that declare a variable, not those that set one element. */
  private static List<Row> rows() {
    List<Row> rows = new ArrayList<>();
    Set<String> names = new HashSet<>();
    BuiltInTable.read(
        "variables.tsv",
        7,
        columns -> {
          Row row = new Row(columns[0], columns[1], columns[2], columns[4]);
          if (names.add(row.baseName())) {
            rows.add(row);
          }
        });
    return rows;
  }

  private static Set<String> strucs() {
    Set<String> strucs = new HashSet<>();
    BuiltInTable.read(
        "types.tsv",
        4,
        columns -> {
          if (columns[0].equals("STRUC")) {
            strucs.add(columns[1]);
          }
        });
    return strucs;
  }

  @Test
  void hasMoreThan250Variables() {
    assertThat(table.names()).hasSizeGreaterThan(250).hasSameSizeAs(rows());
  }

  @Test
  void readsEveryRowOrSaysThatItHasNoValue() throws RefusedException {
    Set<String> strucs = strucs();
    for (Row row : rows()) {
      boolean isStruc = strucs.contains(row.type());
      String name = row.readName(isStruc);
      if (row.value().equals("-") && !isStruc) {
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
      if (row.name().contains("[") || row.value().equals("-") || row.type().equals("SIGNAL")) {
        continue;
      }
      KrlValue declared = KrlValue.parse(row.value());
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
      if (row.value().equals("-") && !isStruc) {
        continue;
      }
      if (row.access().equals("RW") && name.endsWith("[]") && !row.type().equals("CHAR")) {
        name = row.baseName() + "[1]";
      }
      String target = name;
      String text = table.read(target);
      if (row.access().equals("RW")) {
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
