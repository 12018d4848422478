package no.hials.crosscom.gateway.internal.mqtt;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.time.Instant;
import java.time.format.DateTimeFormatter;
import java.time.format.DateTimeFormatterBuilder;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import no.hials.crosscom.cell.JsonLine;
import no.hials.crosscom.cell.Leaf;
import no.hials.crosscom.cell.Units;
import no.hials.crosscom.cell.feed.PlannedVariable;
import no.hials.crosscom.cell.feed.Quality;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;

/** The messages on plain topics. Not thread-safe. */
final class ValueJson {
  private static final DateTimeFormatter TIME =
      new DateTimeFormatterBuilder().appendInstant(3).toFormatter(Locale.ROOT);

  private final Units catalogue = new Units();

  /** The units of the variables and fields, each looked up once. */
  private final Map<String, String> units = new HashMap<>();

  /** Returns a time as {@code 2026-05-04T10:15:30.123Z}. */
  static String time(Instant time) {
    return TIME.format(time);
  }

  /** Returns an object of JSON in UTF-8. */
  static byte[] object(JsonLine.JsonFields fields) {
    return JsonLine.object(fields).getBytes(UTF_8);
  }

  /** Returns the message of an update. */
  byte[] of(Update update) {
    return object(
        json -> {
          json.writeStringField("time", time(update.time()));
          json.writeFieldName("value");
          KrlValue value = update.value();
          if (value == null) {
            json.writeNull();
          } else {
            JsonLine.write(json, value);
            writeUnit(json, update.variable(), value);
          }
          json.writeStringField("quality", update.quality().name().toLowerCase(Locale.ROOT));
          if (update.quality() != Quality.GOOD) {
            json.writeStringField("reason", update.reason());
          }
        });
  }

  private void writeUnit(JsonGenerator json, PlannedVariable variable, KrlValue value)
      throws IOException {
    if (!(value instanceof KrlStruct)) {
      String unit = unit(variable, variable.name());
      if (!unit.isEmpty()) {
        json.writeStringField("unit", unit);
      }
      return;
    }
    boolean open = false;
    for (Leaf leaf : Leaf.of(variable.name(), value)) {
      String unit = unit(variable, leaf.name());
      if (!unit.isEmpty()) {
        if (!open) {
          json.writeObjectFieldStart("unit");
        }
        open = true;
        json.writeStringField(leaf.name().substring(variable.name().length() + 1), unit);
      }
    }
    if (open) {
      json.writeEndObject();
    }
  }

  private String unit(PlannedVariable variable, String leaf) {
    return variable.settings() != null && variable.settings().unit() != null
        ? variable.settings().unit()
        : units.computeIfAbsent(leaf, it -> variable.unit(catalogue, it));
  }
}
