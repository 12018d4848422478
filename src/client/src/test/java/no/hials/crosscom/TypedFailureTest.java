package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import no.hials.crosscom.KRL.KRLReal;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.value.E6Pos;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.protocol.value.Load;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Reads and writes Java values while exchanges fail: a failure is an exception and no value. */
class TypedFailureTest extends RobotTest {
  private static final int ROUNDS = 3_000;

  private record Height(double z) {}

  private static final List<CrossComFunction<?>> READS =
      List.of(
          c -> c.readReal("$OV_PRO"),
          c -> c.readInt("$OV_PRO"),
          c -> c.readRealArray("$TORQUE_AXIS_ACT"),
          c -> c.read("$POS_ACT", E6Pos.class),
          c -> c.read("$BASE", Height.class),
          c -> c.read("$OV_PRO", KrlValue.class),
          c -> c.read(new KRLReal("$OV_PRO")),
          TypedFailureTest::readTwo);

  private static final List<CrossComAction> WRITES =
      List.of(
          c -> c.writeReal("MYREAL", 1),
          c -> c.writeIntArray("MYINTS", 1, 2),
          c -> c.write("$BASE", Frame.IDENTITY),
          c -> c.handle("MYBOOL", Boolean.class).write(true));

  private static Object readTwo(CrossComClient client) throws CrossComException {
    Handle.OfReal override = client.realHandle("$OV_PRO");
    Handle<Frame> base = client.handle("$BASE", Frame.class);
    ReadResults results = client.read(override, base);
    assertThat(results.failures()).isNotEmpty();
    return List.of(results.get(override), results.get(base));
  }

  static Stream<Fault> faults() {
    return Stream.concat(FailureTest.lies(), FailureTest.breaks());
  }

  @ParameterizedTest
  @MethodSource("faults")
  void aReadWhoseAnswerIsWrongOrMissingFails(Fault fault) throws Exception {
    for (CrossComFunction<?> read : READS) {
      try (CrossComClient each = client(LONG)) {
        robot.enqueue(fault);

        assertThatExceptionOfType(CrossComException.class)
            .isThrownBy(() -> read.apply(each))
            .isNotInstanceOf(CrossComValueException.class)
            .satisfies(e -> assertThat(e.isOutcomeUnknown()).isFalse());
        assertThat(each.isClosed()).isTrue();
      }
    }
  }

  @ParameterizedTest
  @MethodSource("faults")
  void theOutcomeOfAWriteIsThenUnknownAndItIsNotRepeated(Fault fault) throws Exception {
    for (CrossComAction write : WRITES) {
      try (CrossComClient each = client(cfg -> cfg.reconnect(true))) {
        robot.clearRequests();
        robot.enqueue(fault);

        assertThatExceptionOfType(CrossComException.class)
            .isThrownBy(() -> write.run(each))
            .satisfies(e -> assertThat(e.isOutcomeUnknown()).isTrue());
        assertThat(robot.requests()).filteredOn(RecordedRequest::isWrite).hasSize(1);
      }
    }
  }

  @ParameterizedTest
  @MethodSource("breaks")
  void aReadIsRepeatedOnceIfTheConnectionBreaks(Fault fault) throws Exception {
    try (CrossComClient steady = client(cfg -> cfg.reconnect(true))) {
      Handle.OfReal override = steady.realHandle("$OV_PRO");
      assertThat(override.readAsDouble()).isEqualTo(100);
      robot.enqueue(fault);

      assertThat(override.readAsDouble()).isEqualTo(100);
    }
  }

  static Stream<Fault> breaks() {
    return FailureTest.breaks();
  }

  /** Returns an answer of a controller with some characters changed. */
  private static String anyAnswer(Random random) {
    return changed(
        random.nextBoolean()
            ? "{E6POS: X 525.5, Y 0.0, Z -890.0, A 0.0, B 90.0, C 1E-2, S 2, T 2, E1 0.0, E2 0.0,"
                + " E3 0.0, E4 0.0, E5 0.0, E6 12.5}"
            : "{LOAD: M 65.0, CM {FRAME: X 180.0, Y 1, Z 2, A 0.0, B 0.0, C 0.0}, J {INERTIA: X"
                + " 19.5, Y 2, Z 3}}",
        random);
  }

  private static String changed(String answer, Random random) {
    StringBuilder text = new StringBuilder(answer);
    String characters = " ,.{}#\"'-+:0129AEXZ[]\u00ff";
    for (int i = random.nextInt(3); i > 0; i--) {
      int at = random.nextInt(text.length());
      int some = random.nextInt(characters.length());
      int end = Math.min(at + random.nextInt(3), text.length());
      text.replace(at, end, characters.substring(some, some + 1));
    }
    return text.toString();
  }

  @Test
  void anyAnswerIsItsValueOrAnExceptionAndTheConnectionCanBeUsed() throws Exception {
    Handle<E6Pos> position = client.handle("MYE6POS", E6Pos.class);
    Handle<Load> load = client.handle("MYLOAD", Load.class);
    Random random = new Random(Long.getLong("seed", 1));
    int values = 0;
    for (int i = 0; i < ROUNDS; i++) {
      String text = anyAnswer(random);
      robot.enqueue(Fault.answer(text, Tail.SUCCESS));
      try {
        if (text.contains("LOAD")) {
          Load read = load.read();
          KrlStruct expected = KrlValue.parse(text).asStruct();
          assertThat(read.m()).as(text).isEqualTo(number(expected, "M"));
        } else {
          E6Pos read = position.read();
          KrlStruct expected = KrlValue.parse(text).asStruct();
          assertThat(read.x()).as(text).isEqualTo(number(expected, "X"));
          assertThat(read.e6()).as(text).isEqualTo(number(expected, "E6"));
          assertThat(read.s()).as(text).isEqualTo((int) number(expected, "S"));
        }
        values++;
      } catch (CrossComValueException e) {
        assertThat(e.getText()).isEqualTo(text);
      }
    }
    assertThat(values).isBetween(ROUNDS / 10, ROUNDS - ROUNDS / 10);
    assertThat(client.readInt("$OV_PRO")).isEqualTo(100);
  }

  private enum Mode {
    T1,
    AUT
  }

  @SuppressWarnings("ArrayRecordComponent") // as a user may write it
  private record Seam(double x, int[] layers, String name, Height at) {}

  /** The Java types of handles, and how each value follows from the controller's. */
  private static final Map<Class<?>, Function<KrlValue, Object>> EXPECTED =
      Map.of(
          Double.class, KrlValue::asDouble,
          Integer.class, KrlValue::asInt,
          Boolean.class, KrlValue::asBool,
          String.class, KrlValue::asString,
          Mode.class, value -> Mode.valueOf(value.asEnum().toUpperCase(Locale.ROOT)),
          int[].class, TypedFailureTest::ints,
          Seam.class, value -> seam(value.asStruct()));

  /** An array of one element is printed like the element. */
  private static List<Integer> ints(KrlValue value) {
    return value instanceof KrlInt
        ? List.of(value.asInt())
        : value.asList().stream().map(KrlValue::asInt).toList();
  }

  private static List<Object> seam(KrlStruct struct) {
    return List.of(
        number(struct, "X"),
        IntStream.iterate(1, i -> struct.get("LAYERS[" + i + "]").isPresent(), i -> i + 1)
            .mapToObj(i -> struct.get("LAYERS[" + i + "]").orElseThrow().asInt())
            .toList(),
        struct.get("NAME[]").orElseThrow().asString(),
        number(struct.get("AT").orElseThrow().asStruct(), "Z"));
  }

  private static boolean isValue(String text) {
    try {
      KrlValue.parse(text.strip());
      return true;
    } catch (KrlSyntaxException e) {
      return false;
    }
  }

  /** Returns a value read in a form that has equals. */
  private static Object comparable(Object value) {
    if (value instanceof int[] ints) {
      return Arrays.stream(ints).boxed().toList();
    } else if (value instanceof Double real) {
      return real + 0.0; // no -0.0 (docs/reference/krl-values.md#negative-zero)
    }
    return value instanceof Seam seam
        ? List.of(seam.x() + 0.0, comparable(seam.layers()), seam.name(), seam.at().z() + 0.0)
        : value;
  }

  private static String anyOtherAnswer(Random random) {
    List<String> answers =
        List.of(
            "12.5",
            "-7",
            "TRUE",
            "#T1",
            "\"a b\"",
            "1 2 3 ",
            "{SEAM: X 1.5, LAYERS[1] 1, LAYERS[2] 2, NAME[] \"a\", AT {FRAME: Z 2.5}}");
    return changed(answers.get(random.nextInt(answers.size())), random);
  }

  @Test
  void anyAnswerToSeveralHandlesIsTheValueOrTheFailureOfEach() throws Exception {
    List<Handle<?>> handles = new ArrayList<>();
    EXPECTED.keySet().forEach(type -> handles.add(client.handle("MYINT", type)));
    ServerType type = client.getServer().type();
    Random random = new Random(Long.getLong("seed", 1));
    int values = 0;
    for (int i = 0; i < ROUNDS; i++) {
      String text = anyOtherAnswer(random);
      int answers = type == ServerType.C3_BRIDGE ? 1 : handles.size();
      robot.enqueue(
          Collections.nCopies(answers, Fault.answer(text, Tail.SUCCESS)).toArray(Fault[]::new));
      ReadResults results = client.read(handles.toArray(Handle[]::new));
      for (Handle<?> handle : handles) {
        CrossComException failure = results.failures().get(handle);
        if (failure == null && handle.type() == Seam.class && !isValue(text)) {
          continue; // a field that the record ignores need not be a value
        }
        if (failure == null) {
          assertThat(comparable(results.get(handle)))
              .as("%s as %s", text, handle.type())
              .isEqualTo(EXPECTED.get(handle.type()).apply(KrlValue.parse(text.strip())));
          values++;
        } else if (text.isEmpty()) {
          assertThat(failure).isInstanceOf(CrossComAccessException.class);
        } else {
          assertThat(failure).isInstanceOf(CrossComValueException.class);
          String shown = ((CrossComValueException) failure).getText();
          assertThat(shown.strip()).isEqualTo(text.strip());
        }
      }
    }
    assertThat(values).isGreaterThan(ROUNDS / 10);
    assertThat(client.readInt("$OV_PRO")).isEqualTo(100);
  }

  private static double number(KrlStruct struct, String field) {
    return struct.get(field).orElseThrow().asDouble();
  }
}
