package no.hials.crosscom.kafka.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import org.apache.kafka.connect.data.Schema;
import org.apache.kafka.connect.data.SchemaBuilder;
import org.apache.kafka.connect.data.Struct;
import org.apache.kafka.connect.errors.DataException;
import org.apache.kafka.connect.sink.SinkRecord;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The records that ask for a write. */
class SinkCommandTest {
  private static SinkRecord record(Object key, Object value) {
    return new SinkRecord("commands", 0, null, key, null, value, 7);
  }

  @Test
  void readsAnObjectWithoutASchema() {
    Map<String, ?> value = Map.of("robot", "r1", "variable", "$OV_PRO", "value", 40L);
    assertThat(SinkCommand.of(record(null, value)))
        .isEqualTo(new SinkCommand("r1", "$OV_PRO", "40"));
  }

  @Test
  void readsAStructureAndTakesTheRobotFromTheKey() {
    Schema schema =
        SchemaBuilder.struct()
            .field("variable", Schema.STRING_SCHEMA)
            .field("value", Schema.BOOLEAN_SCHEMA)
            .build();
    Struct value = new Struct(schema).put("variable", "$OUT[4]").put("value", true);
    assertThat(SinkCommand.of(record("r2", value)))
        .isEqualTo(new SinkCommand("r2", "$OUT[4]", "TRUE"));
  }

  @ParameterizedTest
  @CsvSource({"variable,$OV_PRO", "value,5", "robot,r1"})
  void refusesARecordThatLacksSomething(String field, String content) {
    assertThatThrownBy(() -> SinkCommand.of(record(null, Map.of(field, content))))
        .isInstanceOf(DataException.class);
  }

  @Test
  void refusesAValueThatIsNoScalar() {
    Map<String, ?> value = Map.of("robot", "r1", "variable", "X", "value", Map.of());
    assertThatThrownBy(() -> SinkCommand.of(record(null, value)))
        .isInstanceOf(DataException.class)
        .hasMessageContaining("a number, a text or a truth value");
  }
}
