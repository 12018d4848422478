package no.hials.crosscom.protocol.value;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.stream.LongStream;

/**
 * Prints 32-bit floats in both styles, and rounds doubles to them.
 *
 * <p>A KR C4 prints {@code %#.6g} if that text is read as the same float, else {@code %#.9g}, an
 * upper-case exponent, and a {@code 0} after a final point (docs/reference/krl-values.md#real).
 * Ties are assumed to be rounded to even, as by C's printf.
 */
final class RealText {
  private static final double[] POW10 = {
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22
  };

  /** Powers of ten, from 1. */
  static final long[] POWERS = LongStream.iterate(1, power -> 10 * power).limit(19).toArray();

  /** Nine significant digits distinguish any two floats. */
  private static final int MAX_DIGITS = 9;

  /** Instead of a decimal, which has digits. */
  static final long UNSURE = 0;

  private RealText() {}

  /** Returns {@code digits * 10^exponent} if a double computes it with one rounding, else NaN. */
  static double exactly(long digits, int exponent) {
    if (digits <= 1L << 53) {
      if (exponent >= 0 && exponent < POW10.length) {
        return digits * POW10[exponent];
      }
      if (exponent < 0 && -exponent < POW10.length) {
        return digits / POW10[-exponent];
      }
    }
    return Double.NaN;
  }

  /**
   * Returns whether rounding this correctly rounded double to a float is certain to return the
   * float nearest to the original decimal number. A double half-way between two floats is not.
   */
  static boolean narrowsSafely(double value) {
    return (Double.doubleToRawLongBits(value) & 0x1FFF_FFFFL) != 0x1000_0000L
        && (Math.abs(value) >= Float.MIN_NORMAL || value == 0);
  }

  static void append(KrlText out, float value, RealStyle style) {
    if (value == 0) {
      out.append("0.0");
      return;
    }
    if (value < 0) {
      out.append('-');
    }
    float magnitude = Math.abs(value);
    if (style == RealStyle.KRC4) {
      int exponent = Decimal.estimateExponent(magnitude);
      long six = Decimal.of(magnitude, 6, exponent);
      appendG(out, Decimal.is(six, magnitude) ? six : Decimal.of(magnitude, MAX_DIGITS, exponent));
    } else {
      appendShortest(out, magnitude);
    }
  }

  private static void appendShortest(KrlText out, float magnitude) {
    long decimal = shortest(magnitude);
    int exponent = Decimal.exponent(decimal);
    if (exponent >= -4 && exponent < MAX_DIGITS) {
      appendFixed(out, decimal, Math.max(1, Decimal.precision(decimal) - 1 - exponent));
    } else {
      appendScientific(out, decimal);
    }
  }

  private static long shortest(float magnitude) {
    long fast = shortestByDouble(magnitude);
    return fast != UNSURE ? fast : shortestExactly(magnitude);
  }

  /**
   * Finds the decimal with the fewest digits between the float and half-way to its neighbours, in
   * double arithmetic.
   *
   * @return the decimal, or UNSURE where the rounding of a double could matter
   */
  static long shortestByDouble(float magnitude) {
    int exponent = Decimal.estimateExponent(magnitude);
    int shift = MAX_DIGITS - 1 - exponent;
    if (magnitude < Float.MIN_NORMAL || Math.abs(shift) >= POW10.length) {
      return UNSURE;
    }
    boolean powerOfTwo = isPowerOfTwo(magnitude);
    double scale = shift >= 0 ? POW10[shift] : 1 / POW10[-shift];
    double nine = magnitude * scale; // has nine digits before the point
    double half = Math.ulp(magnitude) * scale * (powerOfTwo ? 0.25 : 0.5);
    double above = nine + half;
    double below = nine - half;
    if (nine < 1e8 || above >= 1e9 || isNearInteger(above) || isNearInteger(below)) {
      return UNSURE;
    }
    // whether there is a number with final zeros between the limits
    long high = (long) above;
    double width = high - below;
    if (high % 1000 < width) {
      // no two decimals of six digits or fewer are the same normal float
      return Decimal.withoutFinalZeros(Decimal.pack(high / 1000, exponent, 6));
    }
    int precision = high % 100 < width ? 7 : high % 10 < width ? 8 : MAX_DIGITS;
    double rounded = nine / POW10[MAX_DIGITS - precision] + 0.5;
    return powerOfTwo || isNearInteger(rounded)
        ? UNSURE
        : Decimal.pack((long) rounded, exponent, precision);
  }

  private static boolean isNearInteger(double value) {
    return Math.abs(value - Math.rint(value)) < 1e-5;
  }

  private static boolean isPowerOfTwo(float magnitude) {
    return (Float.floatToRawIntBits(magnitude) & 0x7F_FFFF) == 0;
  }

  static long shortestExactly(float magnitude) {
    // Below a power of two the floats lie twice as close as above it. The nearest decimal, when it
    // lies below, may then be another float's, and the next one above still this float's.
    boolean powerOfTwo = isPowerOfTwo(magnitude);
    int exponent = Decimal.estimateExponent(magnitude);
    for (int precision = 1; precision < MAX_DIGITS; precision++) {
      long nearest = Decimal.of(magnitude, precision, exponent);
      if (Decimal.is(nearest, magnitude)) {
        return nearest;
      }
      if (powerOfTwo) {
        long above =
            Decimal.pack(Decimal.digits(nearest) + 1, Decimal.exponent(nearest), precision);
        if (Decimal.is(above, magnitude)) {
          return above;
        }
      }
    }
    return Decimal.of(magnitude, MAX_DIGITS, exponent);
  }

  /** C's {@code %#g}. */
  private static void appendG(KrlText out, long decimal) {
    if (Decimal.exponent(decimal) < -4 || Decimal.exponent(decimal) >= Decimal.precision(decimal)) {
      appendScientific(out, decimal);
    } else {
      appendFixed(
          out, decimal, Math.max(1, Decimal.precision(decimal) - 1 - Decimal.exponent(decimal)));
    }
  }

  private static void appendFixed(KrlText out, long decimal, int decimals) {
    // with at least one digit after the point: the 0 after a final point
    int zeros = Decimal.exponent(decimal) + decimals + 1 - Decimal.precision(decimal);
    long number = Decimal.digits(decimal) * POWERS[zeros];
    out.appendDigits(number / POWERS[decimals], 1);
    out.append('.');
    out.appendDigits(number % POWERS[decimals], decimals);
  }

  private static void appendScientific(KrlText out, long decimal) {
    int decimals = Math.max(1, Decimal.precision(decimal) - 1);
    int exponent = Decimal.exponent(decimal);
    appendFixed(
        out, Decimal.pack(Decimal.digits(decimal), 0, Decimal.precision(decimal)), decimals);
    out.append('E');
    out.append(exponent < 0 ? '-' : '+');
    out.appendDigits(Math.abs(exponent), 2);
  }

  /**
   * A positive number as decimal digits, packed into a long, so that printing creates no objects:
   * up to nine digits, of which the first is not 0; the power of ten of the first digit; and the
   * number of digits.
   */
  private static final class Decimal {
    private static final int EXPONENT_BIAS = 128;

    private Decimal() {}

    static long pack(long digits, int exponent, int precision) {
      return digits << 16 | (exponent + EXPONENT_BIAS) << 8 | precision;
    }

    static long digits(long decimal) {
      return decimal >> 16;
    }

    static int exponent(long decimal) {
      return ((int) decimal >> 8 & 0xFF) - EXPONENT_BIAS;
    }

    static int precision(long decimal) {
      return (int) decimal & 0xFF;
    }

    /** Returns the power of ten of the first digit, in rare cases one more or less. */
    static int estimateExponent(float magnitude) {
      int exponent = (Math.getExponent(magnitude) * 1233) >> 12; // 1233 / 4096 is log10(2)
      int next = exponent + 1;
      boolean low =
          next >= 0
              ? next < POW10.length && magnitude >= POW10[next]
              : -next < POW10.length && magnitude * POW10[-next] >= 1;
      return low ? next : exponent;
    }

    /**
     * Rounds half to even, from the exact value of the float.
     *
     * @param estimate the exponent, or one more or less
     */
    static long of(float magnitude, int precision, int estimate) {
      double value = magnitude;
      int exponent = estimate;
      // the estimate may be one off, and rounding up may add a digit
      for (int attempt = 0; attempt < 3; attempt++) {
        int shift = precision - 1 - exponent;
        if (Math.abs(shift) >= POW10.length) {
          break;
        }
        double scaled = shift >= 0 ? value * POW10[shift] : value / POW10[-shift];
        double rounded = Math.rint(scaled);
        if (Math.abs(Math.abs(scaled - rounded) - 0.5) < 1e-6) {
          // too near a tie for a product that was itself rounded
          break;
        }
        if (rounded >= POW10[precision]) {
          exponent++;
        } else if (rounded < POW10[precision - 1]) {
          exponent--;
        } else {
          return pack((long) rounded, exponent, precision);
        }
      }
      BigDecimal exact =
          new BigDecimal(value).round(new MathContext(precision, RoundingMode.HALF_EVEN));
      int leading = exact.precision() - 1 - exact.scale();
      return pack(
          exact.scaleByPowerOfTen(precision - 1 - leading).longValueExact(), leading, precision);
    }

    static long withoutFinalZeros(long decimal) {
      long fewer = digits(decimal);
      int left = precision(decimal);
      while (fewer % 10 == 0) {
        fewer /= 10;
        left--;
      }
      return pack(fewer, exponent(decimal), left);
    }

    /** Returns whether the digits, as text, are read as this float. */
    static boolean is(long decimal, float magnitude) {
      long digits = digits(decimal);
      int scale = exponent(decimal) - precision(decimal) + 1;
      double value = exactly(digits, scale);
      if (Double.isNaN(value) || !narrowsSafely(value)) {
        return Float.parseFloat(digits + "E" + scale) == magnitude;
      }
      return (float) value == magnitude;
    }
  }
}
