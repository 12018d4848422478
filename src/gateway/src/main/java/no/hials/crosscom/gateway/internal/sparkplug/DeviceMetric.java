package no.hials.crosscom.gateway.internal.sparkplug;

import java.time.Instant;
import java.util.Date;
import no.hials.crosscom.cell.Leaf;
import no.hials.crosscom.cell.feed.Quality;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlValue;
import org.eclipse.tahu.SparkplugInvalidTypeException;
import org.eclipse.tahu.message.model.Metric;
import org.eclipse.tahu.message.model.MetricDataType;
import org.eclipse.tahu.message.model.PropertyDataType;
import org.eclipse.tahu.message.model.PropertySet;
import org.eclipse.tahu.message.model.PropertyValue;
import org.jspecify.annotations.Nullable;

/** A number, text or truth value of a robot, as it was last read. Not thread-safe. */
final class DeviceMetric {
  private static final String QUALITY = "Quality";
  private static final String UNIT = "engUnit";

  private final String name;

  /** The variable that it is read with, in upper case; empty if it is no longer configured. */
  private final String variable;

  private final long alias;
  private final String unit;
  private MetricDataType type;
  private @Nullable Object value;
  private Instant time = Instant.now();
  private Quality quality = Quality.STALE;
  private boolean tellsQuality = true;

  DeviceMetric(String name, String variable, long alias, String unit, MetricDataType type) {
    this.name = name;
    this.variable = variable;
    this.alias = alias;
    this.unit = unit;
    this.type = type;
  }

  /** Returns the type of a value. */
  static MetricDataType type(KrlValue value) {
    if (value instanceof KrlInt) {
      return MetricDataType.Int32;
    }
    if (value instanceof KrlReal) {
      return MetricDataType.Float;
    }
    return value instanceof KrlBool ? MetricDataType.Boolean : MetricDataType.String;
  }

  String name() {
    return name;
  }

  long alias() {
    return alias;
  }

  MetricDataType type() {
    return type;
  }

  boolean isBad() {
    return quality == Quality.BAD;
  }

  /** Returns whether its value is of a reading at a time. */
  boolean isOf(Instant readAt) {
    return time.equals(readAt);
  }

  boolean isOf(String key) {
    return variable.equals(key);
  }

  /** Sets the value, and returns whether its type has changed. */
  boolean take(Leaf leaf, Instant readAt, Quality now) {
    KrlValue read = leaf.value();
    MetricDataType next = type(read);
    // a controller can print a REAL without a decimal point
    if (read instanceof KrlInt && type.equals(MetricDataType.Float)) {
      next = type;
    }
    boolean other = !type.equals(next);
    type = next;
    if (type.equals(MetricDataType.Float)) {
      value = (float) read.asDouble();
    } else if (read instanceof KrlInt number) {
      value = number.value();
    } else if (read instanceof KrlBool bool) {
      value = bool.value();
    } else {
      value = leaf.text();
    }
    time = readAt;
    become(now);
    return other;
  }

  /** Marks the value as stale or bad. */
  void without(Quality why, Instant failedAt) {
    time = failedAt;
    if (why == Quality.BAD) {
      value = null;
    }
    become(why);
  }

  private void become(Quality next) {
    tellsQuality = next != quality || next != Quality.GOOD;
    quality = next;
  }

  /** Returns the metric of a birth. */
  Metric birth() {
    return Payloads.metric(
        new Metric.MetricBuilder(name, type, value)
            .alias(alias)
            .timestamp(Date.from(time))
            .properties(properties(true)));
  }

  /** Returns the metric of a change. */
  Metric data() {
    Metric.MetricBuilder builder =
        new Metric.MetricBuilder(Long.valueOf(alias), type, value).timestamp(Date.from(time));
    return Payloads.metric(tellsQuality ? builder.properties(properties(false)) : builder);
  }

  /** Returns the metric to store. It has no alias: the alias can change before it is sent. */
  Metric stored() {
    return Payloads.metric(
        new Metric.MetricBuilder(name, type, value)
            .timestamp(Date.from(time))
            .isHistorical(true)
            .properties(properties(false)));
  }

  private PropertySet properties(boolean withUnit) {
    // the quality codes of Sparkplug
    int number =
        switch (quality) {
          case GOOD -> 192;
          case BAD -> 0;
          case STALE -> 500;
        };
    try {
      PropertySet.PropertySetBuilder builder =
          new PropertySet.PropertySetBuilder()
              .addProperty(QUALITY, new PropertyValue<>(PropertyDataType.Int32, number));
      if (withUnit && !unit.isEmpty()) {
        builder = builder.addProperty(UNIT, new PropertyValue<>(PropertyDataType.String, unit));
      }
      return builder.createPropertySet();
    } catch (SparkplugInvalidTypeException e) {
      throw new IllegalStateException(e);
    }
  }
}
