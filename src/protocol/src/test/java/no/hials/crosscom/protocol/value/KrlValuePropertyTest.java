package no.hials.crosscom.protocol.value;

import static no.hials.crosscom.protocol.Samples.anyOf;
import static no.hials.crosscom.protocol.Samples.between;
import static no.hials.crosscom.protocol.Samples.forAll;
import static no.hials.crosscom.protocol.Samples.list;
import static no.hials.crosscom.protocol.Samples.oneOf;
import static no.hials.crosscom.protocol.Samples.text;
import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

final class KrlValuePropertyTest {
  /** The characters of KRL texts, and some others. */
  private static final String ALPHABET = "{}[]:,\"'#+-. \t\nETFBHX$_0159abe!\u00E5\u20AC";

  private static final String LETTERS = "ABCXYZabcxyz_$TEFH";
  private static final String DIGITS = "0123456789";
  private static final int TRIES = 500;

  @Test
  void aPrintedValueIsParsedAsItself() {
    forAll(
        TRIES,
        KrlValuePropertyTest::value,
        value -> assertThat(KrlValue.parse(value.print())).isEqualTo(value));
  }

  @Test
  void aValuePrintedForWritingIsParsedAsItselfWithoutTypes() {
    forAll(
        TRIES,
        KrlValuePropertyTest::value,
        value -> assertThat(KrlValue.parse(value.printShort())).isEqualTo(withoutTypes(value)));
  }

  @Test
  void anyTextIsAValueOrASyntaxErrorWithinIt() {
    int[] parsed = new int[1];
    forAll(
        TRIES,
        KrlValuePropertyTest::input,
        text -> {
          KrlValue value;
          try {
            value = KrlValue.parse(text);
          } catch (KrlSyntaxException e) {
            assertThat(e.position()).isBetween(0, text.length());
            assertThat(e.text()).isEqualTo(text);
            return;
          }
          parsed[0]++;
          assertThat(KrlValue.parse(value.print())).isEqualTo(value);
        });
    // Else the run tried nearly nothing but values, or nearly nothing but noise.
    assertThat(parsed[0]).isBetween(TRIES / 20 + 1, TRIES * 19 / 20 - 1);
  }

  @Test
  void aRealIsTheDoubleAndTheFloatNearestToItsText() {
    forAll(
        10_000,
        KrlValuePropertyTest::decimal,
        text -> {
          float nearest = Float.parseFloat(text);
          if (Float.isInfinite(nearest)) {
            assertThat(error(text)).isEqualTo("a REAL within ±3.4028235E38");
            return;
          }
          assertThat(new KrlScanner(text).readReal()).isEqualTo(Double.parseDouble(text));
          assertThat(new KrlScanner(text).readFloat()).isEqualTo(nearest);
        });
  }

  /** Texts that rounding to double and then to float would get wrong. */
  @Test
  void aTextHalfWayBetweenTwoFloatsIsRoundedOnce() {
    forAll(
        5_000,
        KrlValuePropertyTest::nearlyHalfWay,
        text -> assertThat(new KrlScanner(text).readFloat()).isEqualTo(Float.parseFloat(text)));
  }

  /** On the middle of two floats, or next to it by so little that a double does not show it. */
  private static String nearlyHalfWay(Random r) {
    float value = Float.intBitsToFloat(r.nextInt(Float.floatToIntBits(Float.MAX_VALUE)));
    String nudge = anyOf(r, "0", "1E-9", "-1E-9", "1E-30", "-1E-30");
    BigDecimal low = new BigDecimal(value);
    BigDecimal high = new BigDecimal(Math.nextUp(value));
    BigDecimal middle = low.add(high).divide(BigDecimal.valueOf(2));
    return middle.add(middle.ulp().multiply(new BigDecimal(nudge))).toString();
  }

  private static String error(String text) {
    try {
      return "no error but " + new KrlScanner(text).readFloat();
    } catch (KrlSyntaxException e) {
      return e.expected();
    }
  }

  /** Returns a value without the type names of its aggregates. */
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

  private static KrlValue value(Random r) {
    return oneOf(r, () -> scalar(r), () -> array(r), () -> struct(r, 3), () -> struct(r, 6));
  }

  private static KrlValue scalar(Random r) {
    return oneOf(
        r, () -> integer(r), () -> real(r), () -> bool(r), () -> enumValue(r), () -> string(r));
  }

  private static KrlValue integer(Random r) {
    return new KrlInt(between(r, Integer.MIN_VALUE, Integer.MAX_VALUE));
  }

  private static KrlValue real(Random r) {
    float value =
        r.nextBoolean()
            ? Float.intBitsToFloat(r.nextInt())
            : between(r, -10_000_000, 10_000_000) / 1000f;
    return Float.isFinite(value) ? new KrlReal(value) : real(r);
  }

  private static KrlValue bool(Random r) {
    return new KrlBool(r.nextBoolean());
  }

  private static KrlValue enumValue(Random r) {
    return new KrlEnum(name(r));
  }

  private static KrlValue string(Random r) {
    String text = r.nextBoolean() ? text(r, 20, Character.MAX_VALUE) : text(r, 0, 20, ALPHABET);
    return new KrlString(text.replace("\"", ""));
  }

  private static KrlValue array(Random r) {
    return switch (r.nextInt(4)) {
      case 0 -> new KrlArray(list(r, 1, 6, () -> integer(r)));
      case 1 -> new KrlArray(list(r, 1, 6, () -> real(r)));
      case 2 -> new KrlArray(list(r, 1, 6, () -> bool(r)));
      default -> new KrlArray(list(r, 1, 6, () -> enumValue(r)));
    };
  }

  private static KrlValue struct(Random r, int depth) {
    Map<String, KrlStruct.Field> fields = new TreeMap<>();
    for (KrlStruct.Field field : list(r, 0, depth == 0 ? 14 : 4, () -> field(r, depth))) {
      fields.put(field.name().toUpperCase(Locale.ROOT), field);
    }
    String type = r.nextInt(10) < 3 ? null : name(r);
    return new KrlStruct(type, new ArrayList<>(fields.values()));
  }

  private static KrlStruct.Field field(Random r, int depth) {
    return switch (r.nextInt(depth == 0 ? 2 : 6)) {
      case 0 -> new KrlStruct.Field(name(r) + "[]", array(r));
      case 1, 2, 3 -> new KrlStruct.Field(fieldName(r), scalar(r));
      default -> new KrlStruct.Field(fieldName(r), struct(r, depth - 1));
    };
  }

  private static String name(Random r) {
    return text(r, 1, 1, LETTERS) + text(r, 0, 6, LETTERS + DIGITS);
  }

  private static String fieldName(Random r) {
    return name(r) + anyOf(r, "", "", "", "[1]", "[2,3]", "[1,]");
  }

  /** Noise, and the texts of values with a few characters changed, which reaches deeper. */
  private static String input(Random r) {
    return switch (r.nextInt(3)) {
      case 0 -> text(r, 0, 12, ALPHABET);
      case 1 -> text(r, 10, Character.MAX_VALUE);
      default -> {
        String text = value(r).print();
        for (Edit edit : list(r, 0, 3, () -> edit(r))) {
          text = edit.apply(text);
        }
        yield text;
      }
    };
  }

  private static Edit edit(Random r) {
    return new Edit(
        r.nextInt(4), between(r, 0, 1000), ALPHABET.charAt(r.nextInt(ALPHABET.length())));
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
  private static String decimal(Random r) {
    String number =
        oneOf(
            r,
            () -> digits(r),
            () -> digits(r) + ".",
            () -> "." + digits(r),
            () -> digits(r) + "." + digits(r));
    String exponent =
        oneOf(
            r,
            () -> "",
            () -> "E" + between(r, -60, 50),
            () -> "e+" + between(r, 0, 40),
            () -> "E-0" + r.nextInt(10),
            () -> "E" + between(r, Integer.MIN_VALUE, Integer.MAX_VALUE));
    return anyOf(r, "", "", "-", "+") + number + exponent;
  }

  private static String digits(Random r) {
    return oneOf(
        r,
        () -> text(r, 1, 3, DIGITS),
        () -> text(r, 1, 9, DIGITS),
        () -> text(r, 15, 20, DIGITS),
        () -> text(r, 1, 60, DIGITS),
        () -> text(r, 1, 40, "0"));
  }
}
