package no.hials.crosscom.protocol.value;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.entry;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Stream;
import no.hials.crosscom.protocol.AnswerFrame;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Samples;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

final class KrlScannerTest {
  private static KrlScanner scanner(String text) {
    return new KrlScanner(text);
  }

  /** Reads an aggregate of numbers as a client's typed variable does. */
  private static Map<String, Double> readFields(KrlScanner scanner) {
    Map<String, Double> fields = new LinkedHashMap<>();
    scanner.openStruct();
    while (scanner.nextField()) {
      fields.put(scanner.fieldName(), scanner.readReal());
    }
    scanner.expectEnd();
    return fields;
  }

  @Test
  void anAggregateIsReadFieldByField() {
    assertThat(readFields(scanner("{E6POS: X 840.229, T 34, B 2.22039314E-12}")))
        .containsExactly(entry("X", 840.229), entry("T", 34.0), entry("B", 2.22039314E-12));
  }

  /** Skips all fields of an aggregate. */
  private static void skipFields(String text) {
    KrlScanner scanner = scanner(text);
    scanner.openStruct();
    while (scanner.nextField()) {
      scanner.skipFieldValue();
    }
    scanner.expectEnd();
  }

  @Test
  void aFieldOfAnyTypeIsSkipped() {
    KrlScanner scanner =
        scanner("{A 1.5, B[] \"}, {\", C {FRAME: X 1, D {E #F}}, G[] 1 2 , H TRUE, LAST 7}");

    scanner.openStruct();
    while (scanner.nextField() && !scanner.fieldIs("LAST")) {
      scanner.skipFieldValue();
    }

    assertThat(scanner.readInt()).isEqualTo(7);
    assertThat(scanner.nextField()).isFalse();
  }

  @Test
  void aSkippedFieldHasAnEnd() {
    for (String text : List.of("{A 1", "{A {B 1}", "{A \"x}", "{A[] \"x\" 1}", "{A {B 1} 2}")) {
      assertThatExceptionOfType(KrlSyntaxException.class)
          .as(text)
          .isThrownBy(() -> skipFields(text));
    }
  }

  @Test
  void whatCanBeParsedCanBeSkipped() {
    Samples.forAll(
        20_000,
        random -> {
          StringBuilder text = new StringBuilder("{LOAD: M 1.5,CM {X 1, Y 2},N[] \"a\", I[] 1 2 }");
          for (int i = random.nextInt(3); i > 0; i--) {
            int at = random.nextInt(text.length());
            text.replace(
                at, at + random.nextInt(2), Samples.anyOf(random, "", " ", ",", "}", "{", "\""));
          }
          return text.toString();
        },
        text -> {
          try {
            if (!(KrlValue.parse(text) instanceof KrlStruct)) {
              return;
            }
          } catch (KrlSyntaxException e) {
            return;
          }
          skipFields(text);
        });
  }

  @Test
  void anExpectedFieldIsReadAsAnyOther() {
    Samples.forAll(
        20_000,
        random -> {
          StringBuilder text = new StringBuilder("{E6AXIS: A1 5.123, A2 -90.0,E1 0.5E-3,E2 1 }");
          for (int i = random.nextInt(4); i > 0; i--) {
            int at = random.nextInt(text.length());
            text.replace(at, at + random.nextInt(2), Samples.anyOf(random, "", " ", ",", "}", "A"));
          }
          return text.toString();
        },
        text -> assertThat(readExpected(text)).isEqualTo(readAny(text)));
  }

  private static String readAny(String text) {
    return read(text, KrlScanner::nextField);
  }

  private static String readExpected(String text) {
    Iterator<String> names = List.of("A1", "A2", "E1", "E2").iterator();
    return read(
        text,
        scanner -> (names.hasNext() && scanner.nextFieldIs(names.next())) || scanner.nextField());
  }

  /** Returns the names and values, and the error if there is one. */
  private static String read(String text, Predicate<KrlScanner> toNextField) {
    KrlScanner scanner = scanner(text);
    StringBuilder read = new StringBuilder();
    try {
      scanner.openStruct();
      while (toNextField.test(scanner)) {
        read.append(scanner.fieldName()).append(' ').append(scanner.readReal()).append(',');
      }
      scanner.expectEnd();
    } catch (KrlSyntaxException e) {
      read.append(e.getMessage());
    }
    return read.toString();
  }

  @Test
  void theTypesNameIsKnownAfterOpening() {
    KrlScanner scanner = scanner("{E6pos: X 1}");

    scanner.openStruct();

    assertThat(scanner.fieldName()).isEqualTo("E6pos");
    assertThat(scanner.fieldIs("E6POS")).isTrue();
    assertThat(scanner.fieldIs("POS")).isFalse();
    assertThat(scanner.nextField()).isTrue();
    assertThat(scanner.fieldName()).isEqualTo("X");
    assertThat(scanner.fieldIs("E6POS")).isFalse();
  }

  @ParameterizedTest
  @MethodSource("withoutType")
  void anAggregateWithoutTypeHasAnEmptyTypesName(String text) {
    KrlScanner scanner = scanner(text);

    scanner.openStruct();

    assertThat(scanner.fieldName()).isEmpty();
    assertThat(scanner.fieldIs("X")).isFalse();
  }

  static Stream<String> withoutType() {
    return Stream.of("{X 1}", "{ X 1}", "{}", "{X}", "{X , Y 1}");
  }

  @Test
  void aFieldIsKnownByItsWholeNameInAnyCase() {
    KrlScanner scanner = scanner("{cVel 1, E1 2, NAME[] \"x\", $a_B 3}");
    scanner.openStruct();

    assertThat(scanner.nextField()).isTrue();
    assertThat(scanner.fieldIs("CVEL")).isTrue();
    assertThat(scanner.fieldIs("CVE")).isFalse();
    assertThat(scanner.fieldIs("CVELO")).isFalse();
    assertThat(scanner.readInt()).isEqualTo(1);
    assertThat(scanner.nextField()).isTrue();
    assertThat(scanner.fieldIs("E1")).isTrue();
    assertThat(scanner.fieldIs("E2")).isFalse();
    assertThat(scanner.readInt()).isEqualTo(2);
    assertThat(scanner.nextField()).isTrue();
    assertThat(scanner.fieldIs("NAME[]")).isTrue();
    assertThat(scanner.fieldHasBrackets()).isTrue();
    assertThat(scanner.readString()).isEqualTo("x");
    assertThat(scanner.nextField()).isTrue();
    assertThat(scanner.fieldIs("$A_B")).isTrue();
    assertThat(scanner.fieldHasBrackets()).isFalse();
    assertThat(scanner.readInt()).isEqualTo(3);
    assertThat(scanner.nextField()).isFalse();
    scanner.expectEnd();
  }

  @Test
  void nestedAggregatesAreOpenedByTheCaller() {
    KrlScanner scanner = scanner("{LOAD: M 65.0000, CM {FRAME: X 180.000, Y 1}, J {}, N 7}");

    scanner.openStruct();
    assertThat(scanner.nextField()).isTrue();
    assertThat(scanner.readReal()).isEqualTo(65.0);
    assertThat(scanner.nextField()).isTrue();
    assertThat(scanner.fieldIs("CM")).isTrue();
    scanner.openStruct();
    assertThat(scanner.fieldIs("FRAME")).isTrue();
    assertThat(scanner.nextField()).isTrue();
    assertThat(scanner.readReal()).isEqualTo(180.0);
    assertThat(scanner.nextField()).isTrue();
    assertThat(scanner.readInt()).isEqualTo(1);
    assertThat(scanner.nextField()).isFalse();
    assertThat(scanner.nextField()).isTrue();
    assertThat(scanner.fieldIs("J")).isTrue();
    scanner.openStruct();
    assertThat(scanner.nextField()).isFalse();
    assertThat(scanner.nextField()).isTrue();
    assertThat(scanner.fieldIs("N")).isTrue();
    assertThat(scanner.readInt()).isEqualTo(7);
    assertThat(scanner.nextField()).isFalse();
    scanner.expectEnd();
  }

  @Test
  void uninitialisedFieldsArePassedOver() {
    assertThat(readFields(scanner("{E6POS: X , Y 2, Z, A }"))).containsExactly(entry("Y", 2.0));
    assertThat(readFields(scanner("{E6POS: }"))).isEmpty();
    assertThat(readFields(scanner("{X}"))).isEmpty();
  }

  @Test
  void everyScalarIsReadByItsOwnMethod() {
    String text = " -5 1.5 true #P_ACTIVE \"a, b\" 'HFF' 2.5";
    KrlScanner scanner = scanner(text);

    assertThat(scanner.readInt()).isEqualTo(-5);
    assertThat(scanner.position()).isEqualTo(3);
    assertThat(scanner.readReal()).isEqualTo(1.5);
    assertThat(scanner.readBool()).isTrue();
    assertThat(scanner.readEnum()).isEqualTo("P_ACTIVE");
    assertThat(scanner.readString()).isEqualTo("a, b");
    assertThat(scanner.readInt()).isEqualTo(255);
    assertThat(scanner.readFloat()).isEqualTo(2.5f);
    scanner.expectEnd();
    assertThat(scanner.position()).isEqualTo(text.length());
  }

  static Stream<Arguments> ofAnotherType() {
    return Stream.of(
        read("TRUE", KrlScanner::readInt, 0, "an INT", "'T'"),
        read("1.0", KrlScanner::readInt, 1, "the end of an INT", "'.'"),
        read("", KrlScanner::readInt, 0, "an INT", "the end"),
        read("  \"1\"", KrlScanner::readInt, 2, "an INT", "'\"'"),
        read("#T1", KrlScanner::readReal, 0, "a REAL", "'#'"),
        read("", KrlScanner::readReal, 0, "a REAL", "the end"),
        read("E5", KrlScanner::readReal, 0, "a REAL", "'E'"),
        read("1E39", KrlScanner::readFloat, 0, "a REAL within ±3.4028235E38", "'1'"),
        read("1", KrlScanner::readBool, 0, "TRUE or FALSE", "'1'"),
        read("T", KrlScanner::readBool, 0, "TRUE or FALSE", "'T'"),
        read("4255", KrlScanner::readBool, 0, "TRUE or FALSE", "'4'"),
        read("5", KrlScanner::readString, 0, "a text in double quotes", "'5'"),
        read("T1", KrlScanner::readEnum, 0, "an ENUM constant, such as #T1", "'T'"),
        read("5", KrlScanner::openStruct, 0, "an aggregate in braces", "'5'"),
        read("", KrlScanner::openStruct, 0, "an aggregate in braces", "the end"),
        read("5", KrlScanner::expectEnd, 0, "the end of the value", "'5'"));
  }

  private static Arguments read(
      String text, Consumer<KrlScanner> method, int position, String expected, String found) {
    return arguments(text, method, position, expected, found);
  }

  @ParameterizedTest(name = "[{index}] {0}: {3}")
  @MethodSource("ofAnotherType")
  void aValueOfAnotherTypeIsRefusedWithWhatWasExpected(
      String text, Consumer<KrlScanner> method, int position, String expected, String found) {
    KrlScanner scanner = scanner(text);

    assertThatExceptionOfType(KrlSyntaxException.class)
        .isThrownBy(() -> method.accept(scanner))
        .satisfies(
            e -> {
              assertThat(e.position()).isEqualTo(position);
              assertThat(e.expected()).isEqualTo(expected);
              assertThat(e.found()).isEqualTo(found);
            });
  }

  @Test
  void aCommaOrBraceEndsAScalarOnlyInsideAnAggregate() {
    KrlScanner scanner = scanner("{X 1}");
    scanner.openStruct();
    assertThat(scanner.nextField()).isTrue();
    assertThat(scanner.readInt()).isEqualTo(1);
    assertThat(scanner.nextField()).isFalse();

    scanner.reset("1}");
    assertThatExceptionOfType(KrlSyntaxException.class)
        .isThrownBy(scanner::readInt)
        .withMessageStartingWith("expected the end of an INT at position 1, found '}'");
  }

  @Test
  void aScannerReadsAnotherTextAfterAnError() {
    KrlScanner scanner = scanner("{X {Y {Z ?");
    assertThatExceptionOfType(KrlSyntaxException.class)
        .isThrownBy(
            () -> {
              scanner.openStruct();
              scanner.nextField();
              scanner.openStruct();
              scanner.nextField();
              scanner.readInt();
            });

    scanner.reset("{A 1, B 2}");

    assertThat(scanner.position()).isZero();
    assertThat(scanner.fieldName()).isEmpty();
    assertThat(readFields(scanner)).containsExactly(entry("A", 1.0), entry("B", 2.0));
    scanner.reset("1,");
    assertThatExceptionOfType(KrlSyntaxException.class)
        .as("no aggregate is open any more")
        .isThrownBy(scanner::readInt);
  }

  @Test
  void asManyAggregatesAreOpenedAsMayNest() {
    KrlScanner scanner = scanner("{X ".repeat(65));
    for (int i = 0; i < 64; i++) {
      scanner.openStruct();
      assertThat(scanner.nextField()).isTrue();
    }

    assertThatExceptionOfType(KrlSyntaxException.class)
        .isThrownBy(scanner::openStruct)
        .withMessageStartingWith(
            "expected at most 64 nested aggregates at position 192, found '{', in: ");
  }

  @Test
  void aScannerMadeWithoutATextIsAtItsEnd() {
    KrlScanner scanner = new KrlScanner();

    scanner.expectEnd();

    assertThatExceptionOfType(KrlSyntaxException.class).isThrownBy(scanner::readInt);
  }

  @Test
  void anAnswerIsReadInPlace() throws Exception {
    AnswerFrame answer = new AnswerFrame();
    KrlScanner scanner = new KrlScanner();
    List<Object> read = new ArrayList<>();
    for (String value :
        List.of("{FRAME: X 1.00000, Y -0.18675448}", "{POS: N[] \"\u00E5\u00FF\", X 3}")) {
      byte[] frame = Codec.encode(new ValueResponse(0, MessageType.READ, value, Tail.SUCCESS));
      answer.wrap(frame, frame.length);
      answer.openValue();
      scanner.reset(answer);
      scanner.openStruct();
      read.add(scanner.fieldName());
      while (scanner.nextField()) {
        read.add(scanner.fieldHasBrackets() ? scanner.readString() : scanner.readFloat());
      }
      scanner.expectEnd();
    }

    assertThat(read).containsExactly("FRAME", 1f, -0.18675448f, "POS", "\u00E5\u00FF", 3f);
  }

  @Test
  void anErrorInAnAnswerKeepsTheTextWhenTheBufferChanges() throws Exception {
    byte[] frame = Codec.encode(new ValueResponse(0, MessageType.READ, "{X ?}", Tail.SUCCESS));
    AnswerFrame answer = new AnswerFrame();
    answer.wrap(frame, frame.length);
    answer.openValue();
    KrlScanner scanner = new KrlScanner(answer);
    scanner.openStruct();
    scanner.nextField();
    KrlSyntaxException error = scanner.wrong("a REAL");

    frame[7] = '!';

    assertThat(error.text()).isEqualTo("{X ?}");
    assertThat(error).hasMessage("expected a REAL at position 3, found '?', in: {X ?}");
  }

  @Test
  void aFieldsValueIsReadWhateverItsType() {
    KrlScanner scanner = scanner("{T: A[] 1 2 , B {C: X 1.5}, N[] \"x, y\", L[] 5, E #T1}");
    Map<String, String> read = new LinkedHashMap<>();

    scanner.openStruct();
    while (scanner.nextField()) {
      read.put(scanner.fieldName(), scanner.readFieldValue().print());
    }
    scanner.expectEnd();

    assertThat(read.values()).containsExactly("1 2 ", "{C: X 1.50000}", "\"x, y\"", "5 ", "#T1");
  }

  @Test
  void aFieldThatIsNoArrayHasOneValue() {
    KrlScanner scanner = scanner("{X 1 2}");
    scanner.openStruct();
    scanner.nextField();

    assertThatExceptionOfType(KrlSyntaxException.class)
        .isThrownBy(scanner::readFieldValue)
        .withMessageStartingWith("expected one value, since the field's name has no [] at");
  }

  @Test
  void blanksAreNotMoreToRead() {
    assertThat(scanner("").hasMore()).isFalse();
    assertThat(scanner(" \t\r\n").hasMore()).isFalse();
    assertThat(scanner(" 1").hasMore()).isTrue();
    KrlScanner scanner = scanner("1 2 ");
    scanner.readInt();
    assertThat(scanner.hasMore()).isTrue();
    scanner.readInt();
    assertThat(scanner.hasMore()).isFalse();
  }

  @Test
  void anErrorCanBeMadeForAPlaceAlreadyPassed() {
    KrlScanner scanner = scanner("12 13");
    scanner.readInt();

    assertThat(scanner.wrongAt(0, "a number below 10"))
        .hasMessage("expected a number below 10 at position 0, found '1', in: 12 13");
    assertThat(scanner.text()).isEqualTo("12 13");
  }
}
