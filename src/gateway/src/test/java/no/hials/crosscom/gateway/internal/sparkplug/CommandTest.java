package no.hials.crosscom.gateway.internal.sparkplug;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigInteger;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.function.Consumer;
import org.eclipse.tahu.message.model.Metric;
import org.eclipse.tahu.message.model.MetricDataType;
import org.eclipse.tahu.protobuf.SparkplugBProto.Payload;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class CommandTest {
  private static Command raw(MetricDataType type, Consumer<Payload.Metric.Builder> value) {
    Payload.Metric.Builder metric =
        Payload.Metric.newBuilder().setName("A").setDatatype(type.toIntValue());
    value.accept(metric);
    byte[] payload = Payload.newBuilder().addMetrics(metric).build().toByteArray();
    return Command.decode(ByteBuffer.wrap(payload)).get(0);
  }

  private static Arguments refused(
      MetricDataType type, Consumer<Payload.Metric.Builder> value, String reason) {
    return Arguments.of(raw(type, value), reason);
  }

  static List<Arguments> wrongValues() {
    String none = "a command needs a value";
    return List.of(
        refused(
            MetricDataType.Int32,
            it -> it.setLongValue(30),
            "a value of type Int32 must be in int_value, is 30 in long_value"),
        refused(
            MetricDataType.Float,
            it -> it.setDoubleValue(5.5),
            "a value of type Float must be in float_value, is 5.5 in double_value"),
        refused(
            MetricDataType.Float,
            it -> it.setIntValue(5),
            "a value of type Float must be in float_value, is 5 in int_value"),
        refused(
            MetricDataType.Boolean,
            it -> it.setIntValue(1),
            "a value of type Boolean must be in boolean_value, is 1 in int_value"),
        refused(
            MetricDataType.String,
            it -> it.setBooleanValue(true),
            "a value of type String must be in string_value, is true in boolean_value"),
        refused(MetricDataType.Double, it -> {}, none),
        refused(MetricDataType.Int32, it -> {}, none),
        refused(MetricDataType.Boolean, it -> {}, none),
        refused(MetricDataType.Int32, it -> it.setIsNull(true).setIntValue(5), none),
        refused(
            MetricDataType.Int8,
            it -> it.setIntValue(286),
            "a value of type Int8 must have 8 bits, is 286"),
        refused(
            MetricDataType.Int8,
            it -> it.setIntValue(-129),
            "a value of type Int8 must have 8 bits, is 4294967167"),
        refused(
            MetricDataType.UInt8,
            it -> it.setIntValue(-1),
            "a value of type UInt8 must have 8 bits, is 4294967295"),
        refused(
            MetricDataType.Int16,
            it -> it.setIntValue(65566),
            "a value of type Int16 must have 16 bits, is 65566"),
        refused(
            MetricDataType.UInt32,
            it -> it.setLongValue(1L << 32),
            "a value of type UInt32 must have 32 bits, is 4294967296"),
        refused(
            MetricDataType.DateTime,
            it -> it.setLongValue(5),
            "the type must be one of a number, truth value or text, is 13 (DateTime)"));
  }

  @ParameterizedTest
  @MethodSource("wrongValues")
  void aValueThatItsTypeCannotHaveIsRefused(Command command, String reason) {
    assertThatThrownBy(() -> command.text(MetricDataType.Int32))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(reason);
  }

  static List<Arguments> values() {
    return List.of(
        Arguments.of(MetricDataType.Int8, (byte) -5, "-5"),
        Arguments.of(MetricDataType.Int16, (short) -300, "-300"),
        Arguments.of(MetricDataType.Int32, -70000, "-70000"),
        Arguments.of(MetricDataType.Int64, -5_000_000_000L, "-5000000000"),
        Arguments.of(MetricDataType.UInt8, (short) 255, "255"),
        Arguments.of(MetricDataType.UInt16, 65535, "65535"),
        Arguments.of(MetricDataType.UInt32, 4_294_967_295L, "4294967295"),
        Arguments.of(
            MetricDataType.UInt64, new BigInteger("18446744073709551615"), "18446744073709551615"),
        Arguments.of(MetricDataType.Float, 5.5f, "5.5"),
        Arguments.of(MetricDataType.Double, -0.25, "-0.25"),
        Arguments.of(MetricDataType.Boolean, true, "TRUE"),
        Arguments.of(MetricDataType.String, "#T1", "#T1"));
  }

  @ParameterizedTest
  @MethodSource("values")
  void aValueFromTheEncoderOfTahuIsRead(MetricDataType type, Object value, String text) {
    byte[] payload =
        Payloads.encode(null, List.of(Payloads.metric(new Metric.MetricBuilder("A", type, value))));

    assertThat(Command.decode(ByteBuffer.wrap(payload)))
        .singleElement()
        .satisfies(it -> assertThat(it.text(MetricDataType.Bytes)).isEqualTo(text));
  }

  @Test
  void aNegativeNumberCanHaveTheBitsOfItsType() {
    assertThat(raw(MetricDataType.Int8, it -> it.setIntValue(251)).text(MetricDataType.Int8))
        .isEqualTo("-5");
    assertThat(raw(MetricDataType.UInt32, it -> it.setIntValue(-1)).text(MetricDataType.UInt32))
        .isEqualTo("4294967295");
  }

  @Test
  void aMetricWithoutATypeHasThatOfTheBirth() {
    Command command =
        new Command(Payload.Metric.newBuilder().setAlias(3).setFloatValue(2.5f).build());

    assertThat(command.text(MetricDataType.Float)).isEqualTo("2.5");
    assertThatThrownBy(() -> command.text(MetricDataType.Int32))
        .hasMessage("a value of type Int32 must be in int_value, is 2.5 in float_value");
  }

  @Test
  void aHistoricalValueIsNoCommand() {
    Command command = raw(MetricDataType.Int32, it -> it.setIntValue(5).setIsHistorical(true));

    assertThatThrownBy(() -> command.check("A"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("is_historical must be false in a command, is true");
  }

  @Test
  void aNameMustBeThatOfTheAlias() {
    Command command = raw(MetricDataType.Int32, it -> it.setAlias(3).setIntValue(5));

    command.check("a");
    assertThatThrownBy(() -> command.check("B"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("the name must be that of the alias 3, is A");
  }
}
