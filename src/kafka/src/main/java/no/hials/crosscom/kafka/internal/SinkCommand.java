package no.hials.crosscom.kafka.internal;

import java.util.Locale;
import java.util.Map;
import org.apache.kafka.connect.data.Struct;
import org.apache.kafka.connect.errors.DataException;
import org.apache.kafka.connect.sink.SinkRecord;
import org.jspecify.annotations.Nullable;

/**
 * A write that a record asks for.
 *
 * @param robot the name of the robot
 * @param variable the variable or field
 * @param value the value as KRL writes it
 */
public record SinkCommand(String robot, String variable, String value) {
  /**
   * Reads a record: a structure or an object with {@code robot}, {@code variable} and {@code
   * value}. The key of the record can be the robot instead.
   *
   * @throws DataException if something is missing
   */
  public static SinkCommand of(SinkRecord record) {
    Object robot = field(record.value(), "robot");
    Object variable = field(record.value(), "variable");
    Object value = field(record.value(), "value");
    if (robot == null) {
      robot = record.key();
    }
    if (!(robot instanceof String name) || !(variable instanceof String target)) {
      throw new DataException(
          "must have the texts robot (or the key) and variable, and value; is " + record.value());
    }
    return new SinkCommand(name, target, text(value));
  }

  private static @Nullable Object field(@Nullable Object value, String name) {
    if (value instanceof Struct struct) {
      return struct.schema().field(name) == null ? null : struct.get(name);
    }
    return value instanceof Map<?, ?> map ? map.get(name) : null;
  }

  private static String text(@Nullable Object value) {
    if (value instanceof String text) {
      return text;
    } else if (value instanceof Number number) {
      return number.toString();
    } else if (value instanceof Boolean flag) {
      return flag.toString().toUpperCase(Locale.ROOT);
    }
    throw new DataException("value must be a number, a text or a truth value, is " + value);
  }
}
