package no.hials.crosscom.lab.plot;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/**
 * What is to be drawn: panels under a title.
 *
 * @param title what stands at the top
 * @param panels at least one
 * @param columns how many panels stand side by side, at least 1
 */
public record Chart(String title, List<Panel> panels, int columns) {

  /** Keeps a copy of the panels. */
  public Chart {
    panels = List.copyOf(panels);
    if (panels.isEmpty()) {
      throw new IllegalArgumentException("a chart must have a panel, has none");
    }
    if (columns < 1) {
      throw new IllegalArgumentException("columns must be at least 1, are " + columns);
    }
  }

  /**
   * Creates a chart with its panels one below the other.
   *
   * @param title what stands at the top
   * @param panels at least one
   * @return the chart
   */
  public static Chart stacked(String title, List<Panel> panels) {
    return new Chart(title, panels, 1);
  }

  /**
   * Writes it into a file, over the one that is there.
   *
   * @param file PNG or SVG, by the end of its name
   * @param size in pixels
   * @throws IllegalArgumentException if the name ends neither with .png nor with .svg
   * @throws NoFontsException if this machine has no font to write with
   * @throws IOException if it cannot be written
   */
  public void write(Path file, Size size) throws IOException {
    Format.of(file).write(this, file, size);
  }

  /**
   * The size of a picture.
   *
   * @param width in pixels, 300 to 10,000
   * @param height in pixels, 200 to 10,000
   */
  public record Size(int width, int height) {
    private static final int MAX = 10_000;

    /** Checks the ranges. */
    public Size {
      check("width", width, 300);
      check("height", height, 200);
    }

    private static void check(String what, int value, int min) {
      if (value < min || value > MAX) {
        throw new IllegalArgumentException(
            what + " must be " + min + " to " + MAX + " pixels, is " + value);
      }
    }
  }
}
