package no.hials.crosscom.lab.plot;

import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;

/**
 * The title of a panel, below it the names of its series, wrapped to the width of the panel, and
 * the number of values that are not shown.
 */
final class Legend {
  private static final int LINE_HEIGHT = 20;
  private static final int BASELINE = 14;
  private static final int SAMPLE = 26;
  private static final int SPACE = 6;
  private static final int BETWEEN = 18;
  private static final int INDENT = 8;

  /** A name in the legend and its position. */
  private record Entry(String name, Series.Style style, Look look, double x, int line) {}

  private final Panel panel;
  private final int width;
  private final List<Entry> entries = new ArrayList<>();
  private final String leftOut;
  private final int lines;

  Legend(Panel panel, int width) {
    this.panel = panel;
    this.width = width;
    List<Look> looks = looks(panel);
    int line = panel.title().isEmpty() ? 0 : 1;
    double x = INDENT;
    boolean any = false;
    for (int i = 0; i < looks.size(); i++) {
      Series series = panel.series().get(i);
      if (!series.name().isEmpty()) {
        String name =
            Typeface.fit(series.name(), Typeface.TEXT, width - INDENT - SAMPLE - 2.0 * SPACE);
        double needed = SAMPLE + SPACE + Typeface.width(name, Typeface.TEXT);
        if (any && x + needed > width) {
          line++;
          x = INDENT;
        }
        entries.add(new Entry(name, series.style(), looks.get(i), x, line));
        x += needed + BETWEEN;
        any = true;
      }
    }
    this.leftOut = Typeface.fit(panel.leftOut(), Typeface.TEXT, width - INDENT);
    this.lines = (any ? line + 1 : line) + (leftOut.isEmpty() ? 0 : 1);
  }

  /** Returns the look of each series of a panel. */
  static List<Look> looks(Panel panel) {
    List<Look> looks = new ArrayList<>();
    int guides = 0;
    int others = 0;
    for (Series series : panel.series()) {
      int index = series.style() == Series.Style.GUIDE ? guides++ : others++;
      looks.add(Look.of(series.style(), index));
    }
    return looks;
  }

  int height() {
    return lines * LINE_HEIGHT + 2;
  }

  void paint(Graphics2D g) {
    String title = Typeface.fit(panel.title(), Typeface.HEADING, width - INDENT);
    Typeface.draw(g, title, Typeface.HEADING, Look.INK, INDENT, BASELINE);
    for (Entry entry : entries) {
      double y = entry.line * (double) LINE_HEIGHT;
      SeriesPainter.paintSample(entry.style, entry.look, g, entry.x, y + BASELINE - 4.5, SAMPLE);
      Typeface.draw(g, entry.name, Typeface.TEXT, Look.INK, entry.x + SAMPLE + SPACE, y + BASELINE);
    }
    double bottom = (lines - 1) * (double) LINE_HEIGHT + BASELINE;
    Typeface.draw(g, leftOut, Typeface.TEXT, Look.INK, INDENT, bottom);
  }
}
