package no.hials.crosscom.kafka.internal;

import java.time.Instant;
import java.util.Date;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import no.hials.crosscom.cell.Leaf;
import no.hials.crosscom.cell.Units;
import no.hials.crosscom.cell.feed.PlannedVariable;
import no.hials.crosscom.cell.feed.Quality;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlValue;
import org.apache.kafka.connect.data.Schema;
import org.apache.kafka.connect.data.SchemaBuilder;
import org.apache.kafka.connect.data.Struct;
import org.apache.kafka.connect.data.Timestamp;

/**
 * The values of the records of the source connector. All samples have one schema, whatever their
 * variable is, so that a topic can have several variables with any converter: the fields of a
 * structure are entries of maps. Not thread-safe.
 */
public final class SampleRecords {
  private static final String NAMES = "no.hials.crosscom.kafka.";

  private static final String ROBOT = "robot";
  private static final String VARIABLE = "variable";
  private static final String TIME = "time";
  private static final String QUALITY = "quality";
  private static final String REASON = "reason";
  private static final String RUN = "run";
  private static final String SEQUENCE = "sequence";
  private static final String NUMBERS = "numbers";
  private static final String TEXTS = "texts";
  private static final String FLAGS = "flags";
  private static final String UNITS = "units";
  private static final String GAP = "gap";
  private static final String FROM = "from";
  private static final String TO = "to";
  private static final String MISSED = "missed";
  private static final String LOST = "lost";

  /** The key of a value that has no fields. */
  private static final String SCALAR = "value";

  private static final Schema GAP_SCHEMA =
      SchemaBuilder.struct()
          .name(NAMES + "Gap")
          .version(1)
          .optional()
          .field(FROM, Timestamp.SCHEMA)
          .field(TO, Timestamp.SCHEMA)
          .field(MISSED, Schema.INT64_SCHEMA)
          .field(LOST, Schema.INT64_SCHEMA)
          .build();

  /** The schema of the samples and gaps. */
  public static final Schema SCHEMA =
      SchemaBuilder.struct()
          .name(NAMES + "Sample")
          .version(1)
          .field(ROBOT, Schema.STRING_SCHEMA)
          .field(VARIABLE, Schema.OPTIONAL_STRING_SCHEMA)
          .field(TIME, Timestamp.SCHEMA)
          .field(QUALITY, Schema.STRING_SCHEMA)
          .field(REASON, Schema.OPTIONAL_STRING_SCHEMA)
          .field(RUN, Schema.INT64_SCHEMA)
          .field(SEQUENCE, Schema.INT64_SCHEMA)
          .field(NUMBERS, map(Schema.FLOAT64_SCHEMA))
          .field(TEXTS, map(Schema.STRING_SCHEMA))
          .field(FLAGS, map(Schema.BOOLEAN_SCHEMA))
          .field(UNITS, map(Schema.STRING_SCHEMA))
          .field(GAP, GAP_SCHEMA)
          .build();

  /** The schema of the records that renew the lease. */
  public static final Schema LEASE_SCHEMA =
      SchemaBuilder.struct()
          .name(NAMES + "Lease")
          .version(1)
          .field("connector", Schema.STRING_SCHEMA)
          .field("task", Schema.STRING_SCHEMA)
          .field(TIME, Timestamp.SCHEMA)
          .field("held", Schema.BOOLEAN_SCHEMA)
          .field("robots", Schema.INT32_SCHEMA)
          .field("connected", Schema.INT32_SCHEMA)
          .field("records", Schema.INT64_SCHEMA)
          .field(MISSED, Schema.INT64_SCHEMA)
          .field(LOST, Schema.INT64_SCHEMA)
          .build();

  private final Units catalogue = new Units();

  /** The units of each variable, which are looked up once. */
  private final Map<String, Map<String, String>> units = new HashMap<>();

  /**
   * A time without samples.
   *
   * @param from the time of the last sample before it
   * @param to the time when it ended
   * @param missed the number of readings that were left out
   * @param lost the number of samples that were read and dropped
   * @param reason the reason why samples are missing
   */
  public record Gap(Instant from, Instant to, long missed, long lost, String reason) {}

  private static Schema map(Schema values) {
    return SchemaBuilder.map(Schema.STRING_SCHEMA, values).optional().build();
  }

  private static Struct common(
      String robot, Instant time, String quality, String reason, long run, long sequence) {
    return new Struct(SCHEMA)
        .put(ROBOT, robot)
        .put(TIME, Date.from(time))
        .put(QUALITY, quality)
        .put(REASON, reason.isEmpty() ? null : reason)
        .put(RUN, run)
        .put(SEQUENCE, sequence);
  }

  /** Returns the record value of a gap. */
  static Struct of(String robot, Gap gap, long run, long sequence) {
    return common(robot, gap.to, GAP, gap.reason, run, sequence)
        .put(
            GAP,
            new Struct(GAP_SCHEMA)
                .put(FROM, Date.from(gap.from))
                .put(TO, Date.from(gap.to))
                .put(MISSED, gap.missed)
                .put(LOST, gap.lost));
  }

  /** Returns the record value of a sample. */
  Struct of(String robot, Update update, long run, long sequence) {
    PlannedVariable variable = update.variable();
    Quality quality = update.quality();
    Struct struct =
        common(
                robot,
                update.time(),
                quality.name().toLowerCase(Locale.ROOT),
                update.reason(),
                run,
                sequence)
            .put(VARIABLE, variable.name());
    KrlValue value = update.value();
    if (value != null) {
      put(struct, variable, value);
    }
    return struct;
  }

  private void put(Struct struct, PlannedVariable variable, KrlValue value) {
    Map<String, Double> numbers = new HashMap<>();
    Map<String, String> texts = new HashMap<>();
    Map<String, Boolean> flags = new HashMap<>();
    Map<String, String> known = units.computeIfAbsent(variable.key(), it -> new HashMap<>());
    for (Leaf leaf : Leaf.of(variable.name(), value)) {
      String key = key(variable.name(), leaf.name());
      if (leaf.value() instanceof KrlInt || leaf.value() instanceof KrlReal) {
        // the digits of the controller: a float widened to a double has other ones
        numbers.put(key, Double.valueOf(leaf.text()));
        String unit = known.get(key);
        if (unit == null) {
          known.put(key, variable.unit(catalogue, leaf.name()));
        }
      } else if (leaf.value() instanceof KrlBool bool) {
        flags.put(key, bool.value());
      } else {
        texts.put(key, leaf.text());
      }
    }
    Map<String, String> shown = new HashMap<>();
    numbers
        .keySet()
        .forEach(
            key -> {
              String unit = known.getOrDefault(key, "");
              if (!unit.isEmpty()) {
                shown.put(key, unit);
              }
            });
    putIfAny(struct, NUMBERS, numbers);
    putIfAny(struct, TEXTS, texts);
    putIfAny(struct, FLAGS, flags);
    putIfAny(struct, UNITS, shown);
  }

  private static void putIfAny(Struct struct, String field, Map<String, ?> entries) {
    if (!entries.isEmpty()) {
      struct.put(field, entries);
    }
  }

  /** Returns the key of a leaf: its field, its index, or {@code value}. */
  private static String key(String variable, String leaf) {
    String base =
        Leaf.isWholeArray(variable) ? variable.substring(0, variable.length() - 2) : variable;
    if (leaf.length() <= base.length()) {
      return SCALAR;
    }
    String rest = leaf.substring(base.length());
    return rest.startsWith(".") ? rest.substring(1) : rest.replaceAll("[\\[\\],]", "");
  }
}
