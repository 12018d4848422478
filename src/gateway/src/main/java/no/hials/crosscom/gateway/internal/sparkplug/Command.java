package no.hials.crosscom.gateway.internal.sparkplug;

import com.google.protobuf.InvalidProtocolBufferException;
import java.nio.ByteBuffer;
import java.util.List;
import org.eclipse.tahu.message.model.MetricDataType;
import org.eclipse.tahu.protobuf.SparkplugBProto.Payload;
import org.eclipse.tahu.protobuf.SparkplugBProto.Payload.Metric.ValueCase;
import org.jspecify.annotations.Nullable;

/**
 * A metric of a command. It is not read with Tahu's decoder, which reads a field that the sender
 * has not filled as 0, and cuts numbers that are too large for their type.
 */
record Command(Payload.Metric metric) {
  private static final long BYTE = 1L << Byte.SIZE;
  private static final long SHORT = 1L << Short.SIZE;
  private static final long INT = 1L << Integer.SIZE;

  /**
   * Decodes commands.
   *
   * @throws IllegalArgumentException if the bytes are not a payload
   */
  static List<Command> decode(ByteBuffer payload) {
    try {
      return Payload.parseFrom(payload.duplicate()).getMetricsList().stream()
          .map(Command::new)
          .toList();
    } catch (InvalidProtocolBufferException e) {
      throw new IllegalArgumentException("not a payload of Sparkplug B: " + e.getMessage(), e);
    }
  }

  @Nullable Long alias() {
    return metric.hasAlias() ? metric.getAlias() : null;
  }

  @Nullable String name() {
    return metric.hasName() ? metric.getName() : null;
  }

  /** Returns whether its value is the truth value TRUE. */
  boolean isTrue() {
    return metric.getBooleanValue();
  }

  /** Returns the content of its filled field, for messages; empty if none is filled. */
  String sent() {
    return metric.getValueCase() == ValueCase.VALUE_NOT_SET
        ? ""
        : String.valueOf(
            metric.getField(
                Payload.Metric.getDescriptor()
                    .findFieldByNumber(metric.getValueCase().getNumber())));
  }

  /**
   * Checks that it is for a metric now.
   *
   * @param found the name of the metric that was found by its alias or name
   * @throws IllegalArgumentException if its name is another one, or its value is historical
   */
  void check(String found) {
    if (metric.hasName()
        && !metric.getName().isEmpty()
        && !metric.getName().equalsIgnoreCase(found)) {
      throw new IllegalArgumentException(
          "the name must be that of the alias %d, is %s"
              .formatted(metric.getAlias(), metric.getName()));
    }
    if (metric.getIsHistorical()) {
      throw new IllegalArgumentException("is_historical must be false in a command, is true");
    }
  }

  /**
   * Returns its value as KRL writes it; a text without quotes.
   *
   * @param usual the type of a metric that does not tell it
   * @throws IllegalArgumentException if it has no value, or one that its type cannot have
   */
  String text(MetricDataType usual) {
    if (metric.getIsNull() || metric.getValueCase() == ValueCase.VALUE_NOT_SET) {
      throw new IllegalArgumentException("a command needs a value");
    }
    MetricDataType type =
        metric.hasDatatype() ? MetricDataType.fromInteger(metric.getDatatype()) : usual;
    return switch (String.valueOf(type)) {
      // negative numbers as two's complement of 32 bits or, by some senders, of the type
      case "Int8" -> String.valueOf((byte) whole(type, Byte.MIN_VALUE, BYTE));
      case "Int16" -> String.valueOf((short) whole(type, Short.MIN_VALUE, SHORT));
      case "Int32" -> String.valueOf(whole(type, Integer.MIN_VALUE, INT));
      case "UInt8" -> String.valueOf(whole(type, 0, BYTE));
      case "UInt16" -> String.valueOf(whole(type, 0, SHORT));
      case "UInt32" -> String.valueOf(unsigned(type));
      case "Int64" -> {
        need(type, ValueCase.LONG_VALUE);
        yield String.valueOf(metric.getLongValue());
      }
      case "UInt64" -> {
        need(type, ValueCase.LONG_VALUE);
        yield Long.toUnsignedString(metric.getLongValue());
      }
      case "Float" -> {
        need(type, ValueCase.FLOAT_VALUE);
        yield String.valueOf(metric.getFloatValue());
      }
      case "Double" -> {
        need(type, ValueCase.DOUBLE_VALUE);
        yield String.valueOf(metric.getDoubleValue());
      }
      case "Boolean" -> {
        need(type, ValueCase.BOOLEAN_VALUE);
        yield metric.getBooleanValue() ? "TRUE" : "FALSE";
      }
      case "String", "Text" -> {
        need(type, ValueCase.STRING_VALUE);
        yield metric.getStringValue();
      }
      default ->
          throw new IllegalArgumentException(
              "the type must be one of a number, truth value or text, is "
                  + (metric.hasDatatype() ? metric.getDatatype() + " (" + type + ")" : type));
    };
  }

  private void need(MetricDataType type, ValueCase field) {
    if (metric.getValueCase() != field) {
      throw new IllegalArgumentException(
          "a value of type %s must be in %s, is %s in %s"
              .formatted(type, fieldName(field), sent(), fieldName(metric.getValueCase())));
    }
  }

  private static String fieldName(ValueCase field) {
    return Payload.Metric.getDescriptor().findFieldByNumber(field.getNumber()).getName();
  }

  /** Returns a number of at most 32 bits, which may be larger than its type if it is signed. */
  private int whole(MetricDataType type, int min, long end) {
    need(type, ValueCase.INT_VALUE);
    int value = metric.getIntValue();
    if (value < min || value >= end) {
      throw new IllegalArgumentException(
          "a value of type %s must have %d bits, is %s"
              .formatted(type, Long.numberOfTrailingZeros(end), Integer.toUnsignedString(value)));
    }
    return value;
  }

  /** Returns a UInt32, which Tahu sends in the field for 64 bits and others in that for 32. */
  private long unsigned(MetricDataType type) {
    if (metric.hasIntValue()) {
      return Integer.toUnsignedLong(metric.getIntValue());
    }
    need(type, ValueCase.LONG_VALUE);
    long value = metric.getLongValue();
    if (value < 0 || value >= INT) {
      throw new IllegalArgumentException(
          "a value of type %s must have 32 bits, is %s"
              .formatted(type, Long.toUnsignedString(value)));
    }
    return value;
  }
}
