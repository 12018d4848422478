package no.hials.crosscom.protocol.value;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import no.hials.crosscom.protocol.Samples;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** How REALs are printed and read: docs/reference/krl-values.md#real. */
final class RealTextTest {
  /** No float's text for writing is longer: sign, nine digits, point, exponent. */
  private static final int LONGEST_SHORT_TEXT = 15;

  private static String krc4(float value) {
    return print(value, RealStyle.KRC4);
  }

  private static String shortest(float value) {
    return print(value, RealStyle.SHORTEST);
  }

  private static String print(float value, RealStyle style) {
    StringBuilder out = new StringBuilder();
    KrlPrinter.appendReal(out, value, style);
    return out.toString();
  }

  /**
   * The table of docs/reference/krl-values.md#real, KSS 8.3 and later, where the float is given
   * with all its digits.
   */
  @ParameterizedTest
  @CsvSource({
    "45, 45.0000",
    "106, 106.000",
    "4500, 4500.00",
    "375000, 375000.0",
    "1618101, 1618101.00",
    "2486600, 2.48660E+06",
    "-119.55101, -119.551010",
    "5953.74, 5953.74",
    "-0.18675448, -0.186754480",
    "1794.12939, 1794.12939",
    "0.1, 0.100000",
    "0.0005, 0.000500000",
    "1e19, 1.00000E+19",
    "27.0000057, 27.0000057",
    "18986.8809, 18986.8809",
    "2.99263215, 2.99263215",
    "1588235.25, 1588235.25",
    // the prose of 1.2
    "0, 0.0",
    "-0.0, 0.0",
    "50000, 50000.0",
    "-90, -90.0000"
  })
  void aRealIsPrintedAsAKrc4PrintsIt(float value, String printed) {
    assertThat(krc4(value)).isEqualTo(printed);
    assertThat(Float.parseFloat(printed)).isEqualTo(value == 0 ? 0 : value);
  }

  /**
   * The rows of the table whose float is not given with all its digits, and other controllers'
   * answers.
   */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "4.48259061E-06",
        "2.22039314E-12",
        "-0.0191543195",
        // docs/reference/krl-values.md and docs/reference/wire-format.md#examples, answers of real
        // controllers
        "840.229",
        "-840.229",
        "1794.12939",
        "-135.000",
        "79.0000",
        "65.0000",
        "180.000",
        "19.5000",
        "-1.00000",
        "284.994965",
        "-63.9896393"
      })
  void aTextOfAKrc4IsPrintedAgainAsItWas(String printed) {
    assertThat(krc4(new KrlScanner(printed).readFloat())).isEqualTo(printed);
    assertThat(KrlValue.parse(printed).print()).isEqualTo(printed);
  }

  @ParameterizedTest
  @CsvSource({
    // where %g switches to the exponent
    "0.0001, 0.000100000",
    "0.00009999, 9.99900E-05",
    "999999, 999999.0",
    "1000000, 1.00000E+06",
    "1000001, 1000001.00",
    "16777216, 16777216.0",
    "123456792, 123456792.0",
    "999999936, 999999936.0",
    "1073741824, 1.07374182E+09",
    // rounding up adds a digit: 9.999995 has 1.00000E+01 at six digits, which is another float
    "9.999995, 9.99999523",
    "99999.95, 99999.9531",
    // the ends of the range
    "3.4028235E38, 3.40282347E+38",
    "-3.4028235E38, -3.40282347E+38",
    "1.17549435E-38, 1.17549435E-38",
    "1.4E-45, 1.40130E-45",
    "-1.4E-45, -1.40130E-45"
  })
  void aRealAtALimitOfTheRuleIsPrintedByIt(float value, String printed) {
    assertThat(krc4(value)).isEqualTo(printed).isEqualTo(byTheRule(value));
  }

  /** Ties are rounded to even, as C does; the numbers are exact in binary. */
  @ParameterizedTest
  @CsvSource({
    // ten significant digits, the last a 5
    "131072.0625, 131072.062",
    "131072.1875, 131072.188",
    "-131072.0625, -131072.062",
    "16384.03125, 16384.0312",
    "16384.09375, 16384.0938",
    "2048.515625, 2048.51562",
    "2048.546875, 2048.54688"
  })
  void aTieBetweenTwoTextsGoesToTheEvenDigit(float value, String printed) {
    assertThat(krc4(value)).isEqualTo(printed).isEqualTo(byTheRule(value));
  }

  /** So near to a tie that a double takes them for one; of all floats there are 26 such. */
  @ParameterizedTest
  @CsvSource({
    // 9.17142084500000009939E-10 and so on
    "9.171421E-10, 9.17142085E-10",
    "2.3890271E-7, 2.38902715E-07",
    "7.2377905E29, 7.23779053E+29",
    // 4.7488305349999997E+22 and so on
    "4.7488305E22, 4.74883053E+22",
    "4.500175E-5, 4.50017505E-05",
    "6.5397357E28, 6.53973569E+28",
    "6.205945E-14, 6.20594477E-14"
  })
  void aRealNearATieBetweenTwoTextsGoesToTheNearer(float value, String printed) {
    assertThat(krc4(value)).isEqualTo(printed).isEqualTo(byTheRule(value));
  }

  @Test
  void anyRealIsPrintedByTheRule() {
    Samples.forAll(
        20_000,
        RealTextTest::anyFloat,
        value -> assertThat(krc4(value)).isEqualTo(byTheRule(value)));
  }

  @Test
  void noTextForWritingIsShorter() {
    Samples.forAll(
        20_000,
        RealTextTest::anyFloat,
        value -> {
          String text = shortest(value);

          assertThat(text).hasSizeLessThanOrEqualTo(LONGEST_SHORT_TEXT).containsOnlyOnce(".");
          assertThat(Float.parseFloat(text)).isEqualTo(value);
          assertThat(significantDigits(text))
              .as("digits of %s", text)
              .isEqualTo(fewestDigits(value));
        });
  }

  @Test
  void theFastWayFindsTheSameDigitsAsTheExactOne() {
    Samples.forAll(
        200_000,
        random ->
            Math.abs(
                Samples.oneOf(
                    random,
                    () -> anyFloat(random),
                    () -> random.nextInt(2_000_000) / 1000f,
                    () -> random.nextFloat() * 1000)),
        value -> {
          long fast = RealText.shortestByDouble(value);
          if (fast != RealText.UNSURE) {
            assertThat(fast).isEqualTo(RealText.shortestExactly(value));
          }
        });
  }

  @ParameterizedTest
  @ValueSource(floats = {1, 0.5f, 100, 90, 0.1f, 1250.5f, 5.123457f, 91.234566f, 0.005123456f})
  void theFastWayFindsTheDigitsOfUsualNumbers(float value) {
    assertThat(RealText.shortestByDouble(value)).isNotEqualTo(RealText.UNSURE);
  }

  /** Below a power of two the floats lie twice as close as above it. */
  @Test
  void thePowersOfTwoAndTheirNeighboursArePrintedRight() {
    for (int exponent = Float.MIN_EXPONENT - 23; exponent <= Float.MAX_EXPONENT; exponent++) {
      float power = Math.scalb(1f, exponent);
      for (float value : List.of(power, Math.nextDown(power), Math.nextUp(power))) {
        if (value == 0) {
          continue;
        }
        assertThat(krc4(value)).isEqualTo(byTheRule(value));
        String text = shortest(value);
        assertThat(Float.parseFloat(text)).as(text).isEqualTo(value);
        assertThat(significantDigits(text)).as(text).isEqualTo(fewestDigits(value));
      }
    }
  }

  @Test
  void thePowersOfTenAndTheirNeighboursArePrintedRight() {
    for (int exponent = -45; exponent <= 38; exponent++) {
      float power = Float.parseFloat("1E" + exponent);
      for (float value : List.of(power, Math.nextDown(power), Math.nextUp(power))) {
        if (value == 0) {
          continue;
        }
        assertThat(krc4(value)).isEqualTo(byTheRule(value));
        String text = shortest(value);
        assertThat(Float.parseFloat(text)).as(text).isEqualTo(value);
        assertThat(significantDigits(text)).as(text).isEqualTo(fewestDigits(value));
      }
    }
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0.0",
    "-0.0, 0.0",
    "1, 1.0",
    "-90, -90.0",
    "45.5, 45.5",
    "0.1, 0.1",
    "2486600, 2486600.0",
    "1618101, 1618101.0",
    "123456792, 123456790.0",
    "999999936, 999999940.0",
    "1e9, 1.0E+09",
    "1e19, 1.0E+19",
    "0.0001, 0.0001",
    "0.00012345678, 0.00012345678",
    "0.00001, 1.0E-05",
    "-1.2345678E-38, -1.2345678E-38",
    "3.4028235E38, 3.4028235E+38",
    "1.4E-45, 1.0E-45"
  })
  void aRealForWritingIsPrintedWithTheFewestDigits(float value, String printed) {
    assertThat(shortest(value)).isEqualTo(printed);
  }

  /** Nine digits that cannot be fewer, with a sign and an exponent or zeros before them. */
  @ParameterizedTest
  @ValueSource(strings = {"-1.00000085E-30", "-0.000100000005", "-1.00000006E+37"})
  void aFullE6PosOfTheLongestValuesFitsInto255Bytes(String longest) {
    KrlReal value = new KrlReal(Float.parseFloat(longest));
    List<KrlStruct.Field> fields = new ArrayList<>();
    for (String name : List.of("X", "Y", "Z", "A", "B", "C")) {
      fields.add(new KrlStruct.Field(name, value));
    }
    fields.add(new KrlStruct.Field("S", new KrlInt(Integer.MIN_VALUE)));
    fields.add(new KrlStruct.Field("T", new KrlInt(Integer.MIN_VALUE)));
    for (String name : List.of("E1", "E2", "E3", "E4", "E5", "E6")) {
      fields.add(new KrlStruct.Field(name, value));
    }

    String text = new KrlStruct("E6POS", fields).printShort();

    assertThat(value.printShort()).isEqualTo(longest).hasSize(LONGEST_SHORT_TEXT);
    assertThat(text).hasSizeLessThanOrEqualTo(255);
    assertThat(KrlValue.parse(text)).isEqualTo(new KrlStruct(null, fields));
  }

  @ParameterizedTest
  @ValueSource(
      doubles = {
        Double.NaN,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY,
        // half-way between the largest float and the next, were there one
        3.4028235677973366E38,
        -3.4028235677973366E38,
        1e39,
        Double.MAX_VALUE
      })
  void aNumberThatNoFloatHoldsIsRefused(double value) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> KrlReal.of(value))
        .withMessage("a REAL is a 32-bit float, within ±3.4028235E38 and not NaN, is " + value);
  }

  @ParameterizedTest
  @ValueSource(floats = {Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY})
  void aFloatThatIsNoNumberIsRefused(float value) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new KrlReal(value))
        .withMessage("a REAL must be finite, is " + value);
  }

  @ParameterizedTest
  @CsvSource({
    "0.1, 0.1",
    "-1E-50, 0",
    "3.4028235677973362E38, 3.4028235E38",
    "-3.4028235E38, -3.4028235E38",
    "7E-46, 0",
    "7.1E-46, 1.4E-45"
  })
  void aDoubleIsRoundedToTheNearestReal(double value, float rounded) {
    assertThat(KrlReal.of(value)).isEqualTo(new KrlReal(rounded));
  }

  @Test
  void aNegativeZeroIsZero() {
    assertThat(new KrlReal(-0.0f)).isEqualTo(new KrlReal(0.0f));
    assertThat(KrlValue.parse("-0.0")).isEqualTo(new KrlReal(0.0f));
  }

  /**
   * Forms that controllers print, and the forms docs/reference/krl-values.md#real advises to take.
   */
  static Stream<Arguments> forms() {
    return Stream.of(
        arguments("1E5", 1e5),
        arguments("1e5", 1e5),
        arguments("1.", 1.0),
        arguments(".5", 0.5),
        arguments("-.5", -0.5),
        arguments("+.5", 0.5),
        arguments("1.E+05", 1e5),
        arguments("5.252814E-03", 5.252814e-3),
        arguments("-3.821331E-04", -3.821331e-4),
        arguments("4.48259061E-06", 4.48259061e-6),
        arguments("1.00000E+19", 1e19),
        arguments("90.00000", 90.0),
        arguments("-1.162400", -1.1624),
        arguments("1601.820", 1601.82),
        arguments("-90.0", -90.0),
        arguments("0.0", 0.0),
        arguments("0", 0.0),
        arguments("116", 116.0),
        arguments("-1", -1.0),
        arguments("+7", 7.0),
        arguments("'B0101'", 5.0),
        arguments("'HFFFFFFFF'", -1.0),
        arguments("007.50", 7.5),
        arguments("1E-400", 0.0),
        arguments("0E400", 0.0),
        arguments("0." + "0".repeat(50) + "1E51", 1.0),
        arguments("12345678901234567890123", 1.2345678901234568e22),
        arguments("340282346638528859811704183484516925440", 3.4028234663852886e38));
  }

  @ParameterizedTest
  @MethodSource("forms")
  void aRealIsReadInEveryForm(String text, double value) {
    assertThat(new KrlScanner(text).readReal()).isEqualTo(value);
    assertThat(new KrlScanner(text).readFloat()).isEqualTo((float) value);
  }

  @Test
  void digitsAndExponentMayBeAbsurdlyManyWithoutAWrongNumber() {
    String tiny = "0." + "0".repeat(99_999) + "1E100005";

    assertThat(new KrlScanner(tiny).readReal()).isEqualTo(1e5);
    assertThat(new KrlScanner("1E-99999999999999999999").readReal()).isZero();
    assertThat(new KrlScanner("9".repeat(30) + "." + "9".repeat(100_000)).readReal())
        .isEqualTo(1e30);
  }

  /**
   * Uniform bits, so that every magnitude comes; numbers with few decimals, as programs have them;
   * and whole numbers.
   */
  private static Float anyFloat(Random random) {
    int i = random.nextInt();
    float value =
        switch (random.nextInt(4)) {
          case 0 -> Float.intBitsToFloat(i);
          case 1 -> (i % 10_000_000) / 1000f;
          case 2 -> (i % 100_000) / 100f;
          default -> (float) i;
        };
    return Float.isFinite(value) && value != 0 ? value : anyFloat(random);
  }

  /**
   * The rule of docs/reference/krl-values.md#real, once more and independently: from the exact
   * value, with BigDecimal.
   */
  private static String byTheRule(float value) {
    String text = sharpG(value, 6);
    if (Float.parseFloat(text) != value) {
      text = sharpG(value, 9);
    }
    return text.endsWith(".") ? text + "0" : text;
  }

  /** C's {@code %#.<precision>g} (ISO C 7.21.6.1), with an upper-case exponent. */
  private static String sharpG(float value, int precision) {
    BigDecimal rounded =
        new BigDecimal(value).round(new MathContext(precision, RoundingMode.HALF_EVEN));
    int exponent = rounded.precision() - rounded.scale() - 1;
    if (exponent < -4 || exponent >= precision) {
      String mantissa = rounded.movePointLeft(exponent).setScale(precision - 1).toPlainString();
      String digits = String.valueOf(Math.abs(exponent));
      return mantissa
          + "E"
          + (exponent < 0 ? "-" : "+")
          + (digits.length() < 2 ? "0" : "")
          + digits;
    }
    String fixed = rounded.setScale(precision - 1 - exponent).toPlainString();
    return fixed.contains(".") ? fixed : fixed + ".";
  }

  private static int significantDigits(String text) {
    BigDecimal digits = new BigDecimal(text);
    return digits.stripTrailingZeros().precision();
  }

  /** Searches the decimal numbers next to the float on both sides, beginning with one digit. */
  private static int fewestDigits(float value) {
    BigDecimal exact = new BigDecimal(value);
    for (int precision = 1; ; precision++) {
      for (RoundingMode mode : List.of(RoundingMode.FLOOR, RoundingMode.CEILING)) {
        if (Float.parseFloat(exact.round(new MathContext(precision, mode)).toString()) == value) {
          return precision;
        }
      }
    }
  }
}
