package no.hials.crosscom.cell.recording;

import java.util.regex.Pattern;
import no.hials.crosscom.protocol.value.PrintableText;

/**
 * The texts in cells of CSV files. In a spreadsheet, a cell that begins with {@code =}, {@code +},
 * {@code -}, {@code @}, tab or CR is a formula, which may run a program; an apostrophe before it
 * makes it a text. Where numbers have a decimal comma, a spreadsheet divides lines at semicolons,
 * even between double quotes, so the text after a semicolon may become a cell, too.
 */
public final class CsvText {
  private static final Pattern NUMBER =
      Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");

  /** The beginning of a formula, also full-width, after control characters were escaped. */
  private static final String FORMULA =
      "[\\s\\u00A0\"]*([=+@\\-\\uFF1D\\uFF0B\\uFF20\\uFF0D]|\\\\x0[9D])";

  /** A text with apostrophes before a formula gets one more, which {@link #exact} removes. */
  private static final Pattern UNSAFE = Pattern.compile("(^|;)(?='*" + FORMULA + ")");

  private static final Pattern GUARDED = Pattern.compile("(^|;)'(?='*" + FORMULA + ")");

  private CsvText() {}

  /** Escapes control characters, and puts an apostrophe before a formula that is not a number. */
  public static String guarded(String text) {
    String cell = PrintableText.of(text);
    return NUMBER.matcher(cell).matches() ? cell : UNSAFE.matcher(cell).replaceAll("$1'");
  }

  /** Returns the text of a cell without the apostrophes that guard it. */
  public static String exact(String cell) {
    return GUARDED.matcher(cell).replaceAll("$1");
  }
}
