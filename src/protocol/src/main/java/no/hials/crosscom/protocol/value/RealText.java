package no.hials.crosscom.protocol.value;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

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

  /** Nine significant digits distinguish any two floats. */
  private static final int MAX_DIGITS = 9;

  /** No two decimals with up to this number of digits are the same normal float. */
  private static final int SURE_DIGITS = 6;

  private RealText() {}

  /** Rounds to the nearest float; throws if no float can hold the number. */
  static float toFloat(double value) {
    float f = (float) value;
    if (!Float.isFinite(f)) {
      throw new IllegalArgumentException(
          "a REAL is a 32-bit float, within ±3.4028235E38 and not NaN, is " + value);
    }
    return f;
  }

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

  static void append(StringBuilder out, float value, RealStyle style) {
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

  private static void appendShortest(StringBuilder out, float magnitude) {
    long decimal = shortest(magnitude);
    int exponent = Decimal.exponent(decimal);
    if (exponent >= -4 && exponent < MAX_DIGITS) {
      appendFixed(out, decimal, Math.max(1, Decimal.precision(decimal) - 1 - exponent));
    } else {
      appendScientific(out, decimal);
    }
  }

  private static long shortest(float magnitude) {
    // Below a power of two the floats lie twice as close as above it. The nearest decimal, when it
    // lies below, may then be another float's, and the next one above still this float's.
    boolean powerOfTwo = (Float.floatToRawIntBits(magnitude) & 0x7F_FFFF) == 0;
    int exponent = Decimal.estimateExponent(magnitude);
    int first = 1;
    if (magnitude >= Float.MIN_NORMAL) {
      // No two decimals of up to six digits are the same float, so if six digits are this float,
      // fewer digits can only be the same number without its final zeros.
      long six = Decimal.of(magnitude, SURE_DIGITS, exponent);
      if (Decimal.is(six, magnitude)) {
        return Decimal.withoutFinalZeros(six);
      }
      first = powerOfTwo ? SURE_DIGITS : SURE_DIGITS + 1;
    }
    for (int precision = first; precision < MAX_DIGITS; precision++) {
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
  private static void appendG(StringBuilder out, long decimal) {
    if (Decimal.exponent(decimal) < -4 || Decimal.exponent(decimal) >= Decimal.precision(decimal)) {
      appendScientific(out, decimal);
    } else {
      appendFixed(
          out, decimal, Math.max(1, Decimal.precision(decimal) - 1 - Decimal.exponent(decimal)));
    }
  }

  private static void appendFixed(StringBuilder out, long decimal, int decimals) {
    // with at least one digit after the point: the 0 after a final point
    int exponent = Decimal.exponent(decimal);
    if (exponent < 0) {
      out.append("0.");
      for (int i = -1; i > exponent; i--) {
        out.append('0');
      }
      out.append(Decimal.digits(decimal));
      return;
    }
    int start = out.length();
    out.append(Decimal.digits(decimal));
    for (int i = Decimal.precision(decimal); i <= exponent + decimals; i++) {
      out.append('0');
    }
    out.insert(start + exponent + 1, '.');
  }

  private static void appendScientific(StringBuilder out, long decimal) {
    int start = out.length();
    out.append(Decimal.digits(decimal));
    if (Decimal.precision(decimal) == 1) {
      out.append('0');
    }
    out.insert(start + 1, '.');
    int exponent = Decimal.exponent(decimal);
    out.append('E').append(exponent < 0 ? '-' : '+');
    if (Math.abs(exponent) < 10) {
      out.append('0');
    }
    out.append(Math.abs(exponent));
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
