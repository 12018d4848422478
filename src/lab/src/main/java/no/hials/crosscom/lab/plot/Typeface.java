package no.hials.crosscom.lab.plot;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.font.FontRenderContext;
import java.awt.font.TextLayout;

/** Measures and draws the texts of a chart. */
final class Typeface {
  static final Font TITLE = new Font(Font.SANS_SERIF, Font.BOLD, 17);
  static final Font HEADING = new Font(Font.SANS_SERIF, Font.BOLD, 13);
  static final Font TEXT = new Font(Font.SANS_SERIF, Font.PLAIN, 13);

  /** Independent of the device, so that PNG and SVG have the same layout. */
  private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);

  private Typeface() {}

  /** Checks that Java finds a font. */
  static void check() throws NoFontsException {
    try {
      width("x", TEXT);
    } catch (RuntimeException | Error e) {
      if (e instanceof VirtualMachineError && !(e instanceof InternalError)) {
        throw e;
      }
      // the type depends on what is missing: the JDK's font library, fontconfig, or the fonts
      throw new NoFontsException(e);
    }
  }

  static double width(String text, Font font) {
    return text.isEmpty() ? 0 : new TextLayout(text, font, CONTEXT).getAdvance();
  }

  /** Draws a line of text whose baseline starts at a point. */
  static void draw(Graphics2D g, String text, Font font, Color color, double x, double y) {
    if (text.isEmpty()) {
      return;
    }
    g.setFont(font);
    g.setColor(color);
    g.drawString(printable(text), (float) x, (float) y);
  }

  /** Replaces control characters and unpaired surrogates, which neither fonts nor XML support. */
  static String printable(String text) {
    StringBuilder printable = new StringBuilder();
    text.codePoints()
        .map(c -> c == '\n' || !isControl(c) ? c : 0xFFFD)
        .forEach(printable::appendCodePoint);
    return printable.toString();
  }

  private static boolean isControl(int c) {
    return c < 0x20 || (c >= 0xD800 && c < 0xE000) || c == 0xFFFE || c == 0xFFFF;
  }

  /** Cuts a text to a width; a text that was cut ends with dots. */
  static String fit(String text, Font font, double width) {
    if (width(text, font) <= width) {
      return text;
    }
    int end = text.length();
    while (end > 1 && width(text.substring(0, end) + "…", font) > width) {
      end--;
    }
    return text.substring(0, end) + "…";
  }
}
