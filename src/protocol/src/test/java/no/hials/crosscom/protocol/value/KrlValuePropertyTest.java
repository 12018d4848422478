package no.hials.crosscom.protocol.value;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.RandomDistribution;
import net.jqwik.api.Tuple;
import net.jqwik.api.statistics.Statistics;
import net.jqwik.api.statistics.StatisticsReport;
import net.jqwik.api.statistics.StatisticsReport.StatisticsReportMode;

final class KrlValuePropertyTest {
  /** What KRL texts are made of, and a little that they are not. */
  private static final String ALPHABET = "{}[]:,\"'#+-. \t\nETFBHX$_0159abe!\u00E5\u20AC";

  @Property
  void aPrintedValueIsParsedAsItself(@ForAll("values") KrlValue value) {
    assertThat(KrlValue.parse(value.print())).isEqualTo(value);
  }

  @Property
  void aValuePrintedForWritingIsParsedAsItselfWithoutTypes(@ForAll("values") KrlValue value) {
    assertThat(KrlValue.parse(value.printShort())).isEqualTo(withoutTypes(value));
  }

  @Property
  @StatisticsReport(StatisticsReportMode.OFF)
  void anyTextIsAValueOrASyntaxErrorWithinIt(@ForAll("texts") String text) {
    KrlValue value;
    try {
      value = KrlValue.parse(text);
    } catch (KrlSyntaxException e) {
      assertThat(e.position()).isBetween(0, text.length());
      assertThat(e.text()).isEqualTo(text);
      expectBothOutcomes(false);
      return;
    }
    expectBothOutcomes(true);
    assertThat(KrlValue.parse(value.print())).isEqualTo(value);
  }

  private static void expectBothOutcomes(boolean parsed) {
    Statistics.collect(parsed);
    Statistics.coverage(
        coverage -> {
          coverage.check(true).percentage(p -> p > 5);
          coverage.check(false).percentage(p -> p > 5);
        });
  }

  @Property(tries = 10_000)
  void aRealIsTheDoubleAndTheFloatNearestToItsText(@ForAll("decimals") String text) {
    float nearest = Float.parseFloat(text);
    if (Float.isInfinite(nearest)) {
      assertThat(error(text)).isEqualTo("a REAL within ±3.4028235E38");
      return;
    }
    assertThat(new KrlScanner(text).readReal()).isEqualTo(Double.parseDouble(text));
    assertThat(new KrlScanner(text).readFloat()).isEqualTo(nearest);
  }

  /** Texts that rounding to double and then to float would get wrong. */
  @Property(tries = 5_000)
  void aTextHalfWayBetweenTwoFloatsIsRoundedOnce(
      @ForAll("positiveFloats") float value, @ForAll("nudges") String nudge) {
    BigDecimal low = new BigDecimal(value);
    BigDecimal high = new BigDecimal(Math.nextUp(value));
    BigDecimal middle = low.add(high).divide(BigDecimal.valueOf(2));
    String text = middle.add(middle.ulp().multiply(new BigDecimal(nudge))).toString();

    assertThat(new KrlScanner(text).readFloat()).isEqualTo(Float.parseFloat(text));
  }

  private static String error(String text) {
    try {
      return "no error but " + new KrlScanner(text).readFloat();
    } catch (KrlSyntaxException e) {
      return e.expected();
    }
  }

  /** What is left when an aggregate is written without its type's name. */
  private static KrlValue withoutTypes(KrlValue value) {
    if (value instanceof KrlStruct struct) {
      List<KrlStruct.Field> fields = new ArrayList<>();
      for (KrlStruct.Field field : struct.fields()) {
        fields.add(new KrlStruct.Field(field.name(), withoutTypes(field.value())));
      }
      return new KrlStruct(null, fields);
    }
    return value;
  }

  @Provide
  Arbitrary<KrlValue> values() {
    // without edge cases, which are thousands when combined; KrlValueTest has them
    return Arbitraries.oneOf(scalars(), arrays(), structs(3), structs(6)).withoutEdgeCases();
  }

  private static Arbitrary<KrlValue> scalars() {
    return Arbitraries.oneOf(ints(), reals(), bools(), enums(), strings());
  }

  private static Arbitrary<KrlValue> ints() {
    return Arbitraries.integers().map(KrlInt::new);
  }

  private static Arbitrary<KrlValue> reals() {
    return Arbitraries.oneOf(
            Arbitraries.integers()
                .withDistribution(RandomDistribution.uniform())
                .map(Float::intBitsToFloat),
            Arbitraries.integers().between(-10_000_000, 10_000_000).map(i -> i / 1000f))
        .filter(f -> Float.isFinite(f))
        .map(KrlReal::new);
  }

  private static Arbitrary<KrlValue> bools() {
    return Arbitraries.of(true, false).map(KrlBool::new);
  }

  private static Arbitrary<KrlValue> enums() {
    return names().map(KrlEnum::new);
  }

  private static Arbitrary<KrlValue> strings() {
    return Arbitraries.oneOf(
            Arbitraries.strings().all().ofMaxLength(20),
            Arbitraries.strings().withChars(ALPHABET.replace("\"", "")).ofMaxLength(20))
        .filter(s -> s.indexOf('"') < 0)
        .map(KrlString::new);
  }

  private static Arbitrary<KrlValue> arrays() {
    return Arbitraries.oneOf(arrays(ints()), arrays(reals()), arrays(bools()), arrays(enums()));
  }

  private static Arbitrary<KrlValue> arrays(Arbitrary<KrlValue> elements) {
    return elements.list().ofMinSize(1).ofMaxSize(6).map(KrlArray::new);
  }

  private static Arbitrary<KrlValue> structs(int depth) {
    Arbitrary<KrlStruct.Field> simple =
        Combinators.combine(fieldNames(), scalars()).as(KrlValuePropertyTest::field);
    Arbitrary<KrlStruct.Field> array =
        Combinators.combine(names(), arrays()).as((n, v) -> new KrlStruct.Field(n + "[]", v));
    Arbitrary<KrlStruct.Field> fields =
        depth == 0
            ? Arbitraries.oneOf(simple, array)
            : Arbitraries.frequencyOf(
                Tuple.of(3, simple),
                Tuple.of(1, array),
                Tuple.of(
                    2,
                    Combinators.combine(fieldNames(), structs(depth - 1))
                        .as(KrlValuePropertyTest::field)));
    return Combinators.combine(
            names().injectNull(0.3),
            fields
                .list()
                .uniqueElements(f -> f.name().toUpperCase(Locale.ROOT))
                .ofMaxSize(depth == 0 ? 14 : 4))
        .as(KrlStruct::new);
  }

  private static KrlStruct.Field field(String name, KrlValue value) {
    return new KrlStruct.Field(name, value);
  }

  private static Arbitrary<String> names() {
    String letters = "ABCXYZabcxyz_$TEFH";
    return Combinators.combine(
            Arbitraries.of(letters.chars().mapToObj(c -> (char) c).toList()),
            Arbitraries.strings().withChars(letters + "0123456789").ofMaxLength(6))
        .as((first, rest) -> first + rest);
  }

  private static Arbitrary<String> fieldNames() {
    return Combinators.combine(names(), Arbitraries.of("", "", "", "[1]", "[2,3]", "[1,]"))
        .as((name, index) -> name + index);
  }

  /** Noise, and the texts of values with a few characters changed, which reaches deeper. */
  @Provide
  Arbitrary<String> texts() {
    Arbitrary<String> mutated =
        Combinators.combine(values(), edits().list().ofMaxSize(3))
            .as(
                (value, edits) -> {
                  String text = value.print();
                  for (Edit edit : edits) {
                    text = edit.apply(text);
                  }
                  return text;
                });
    return Arbitraries.oneOf(
            mutated,
            Arbitraries.strings().withChars(ALPHABET).ofMaxLength(12),
            Arbitraries.strings().all().ofMaxLength(10))
        .withoutEdgeCases();
  }

  private static Arbitrary<Edit> edits() {
    return Combinators.combine(
            Arbitraries.integers().between(0, 3),
            Arbitraries.integers().between(0, 1000),
            Arbitraries.of(ALPHABET.chars().mapToObj(c -> (char) c).toList()))
        .as(Edit::new);
  }

  /** Changes a text at a place, given in thousandths of its length. */
  private record Edit(int kind, int place, char c) {
    String apply(String text) {
      int at = (int) ((long) place * text.length() / 1000);
      String before = text.substring(0, at);
      String after = text.substring(at);
      String without = after.isEmpty() ? "" : after.substring(1);
      return switch (kind) {
        case 0 -> before + without;
        case 1 -> before + c + after;
        case 2 -> before + c + without;
        default -> before;
      };
    }
  }

  /** Decimal numbers in every form, with few digits or many. */
  @Provide
  Arbitrary<String> decimals() {
    Arbitrary<String> digits =
        Arbitraries.oneOf(
            Arbitraries.strings().numeric().ofMinLength(1).ofMaxLength(3),
            Arbitraries.strings().numeric().ofMinLength(1).ofMaxLength(9),
            Arbitraries.strings().numeric().ofMinLength(15).ofMaxLength(20),
            Arbitraries.strings().numeric().ofMinLength(1).ofMaxLength(60),
            Arbitraries.strings().withChars("0").ofMinLength(1).ofMaxLength(40));
    Arbitrary<String> number =
        Arbitraries.oneOf(
            digits,
            digits.map(d -> d + "."),
            digits.map(d -> "." + d),
            Combinators.combine(digits, digits).as((a, b) -> a + "." + b));
    Arbitrary<String> exponent =
        Arbitraries.oneOf(
            Arbitraries.just(""),
            Arbitraries.integers().between(-60, 50).map(e -> "E" + e),
            Arbitraries.integers().between(0, 40).map(e -> "e+" + e),
            Arbitraries.integers().between(0, 9).map(e -> "E-0" + e),
            Arbitraries.integers().map(e -> "E" + e));
    return Combinators.combine(Arbitraries.of("", "", "-", "+"), number, exponent)
        .as((sign, n, e) -> sign + n + e)
        .withoutEdgeCases();
  }

  @Provide
  Arbitrary<Float> positiveFloats() {
    return Arbitraries.integers()
        .between(0, Float.floatToIntBits(Float.MAX_VALUE) - 1)
        .withDistribution(RandomDistribution.uniform())
        .map(Float::intBitsToFloat)
        .withoutEdgeCases();
  }

  /** On the middle, and beside it by so little that a double does not show it. */
  @Provide
  Arbitrary<String> nudges() {
    return Arbitraries.of("0", "1E-9", "-1E-9", "1E-30", "-1E-30");
  }
}
