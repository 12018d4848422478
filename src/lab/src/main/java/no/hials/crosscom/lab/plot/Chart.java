package no.hials.crosscom.lab.plot;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.UUID;

/**
 * A chart: panels under a title.
 *
 * @param title the title at the top
 * @param panels the panels, at least one
 * @param columns the number of panels side by side, at least 1
 */
public record Chart(String title, List<Panel> panels, int columns) {

  /** Keeps a copy of the panels. */
  public Chart {
    panels = List.copyOf(panels);
    if (panels.isEmpty()) {
      throw new IllegalArgumentException("a chart must have at least 1 panel, has 0");
    }
    if (columns < 1) {
      throw new IllegalArgumentException("columns must be at least 1, are " + columns);
    }
  }

  /**
   * Creates a chart with its panels one below the other.
   *
   * @param title the title at the top
   * @param panels the panels, at least one
   * @return the chart
   */
  public static Chart stacked(String title, List<Panel> panels) {
    return new Chart(title, panels, 1);
  }

  /**
   * Checks that the chart can be drawn in a size.
   *
   * @param size the size of the picture
   * @throws IllegalArgumentException if the size is too small; the message names one that is not
   * @throws NoFontsException if Java finds no font
   */
  public void checkSize(Size size) throws NoFontsException {
    Format.useNoDisplay();
    ChartPainter.check(this, size);
  }

  /**
   * Writes the chart to a file and replaces an existing file. The picture is complete or not there:
   * it is written to a temporary file next to the file, which is then renamed.
   *
   * @param file the file; the end of its name decides between PNG and SVG
   * @param size the size of the picture
   * @throws IllegalArgumentException if the name ends neither with .png nor with .svg, or if the
   *     size is too small; the message names one that is not
   * @throws NoFontsException if Java finds no font
   * @throws IOException if the file cannot be written
   */
  public void write(Path file, Size size) throws IOException {
    byte[] picture = Format.of(file).draw(this, size);
    if (Files.exists(file) && !Files.isRegularFile(file)) {
      Files.write(file, picture); // to a device or a pipe
      return;
    }
    Path target = Files.exists(file) ? file.toRealPath() : file;
    Path part = target.resolveSibling("plot-" + UUID.randomUUID() + ".part");
    try {
      part.toFile().deleteOnExit();
    } catch (IllegalStateException e) {
      // the program is ending after Ctrl-C, and waits for this picture
    }
    try {
      Files.write(part, picture, StandardOpenOption.CREATE_NEW);
      Files.move(part, target, StandardCopyOption.ATOMIC_MOVE);
    } finally {
      Files.deleteIfExists(part);
    }
  }

  /**
   * The size of a picture.
   *
   * @param width in pixels, 300 to 10,000
   * @param height in pixels, 200 to 10,000
   */
  public record Size(int width, int height) {
    private static final int MAX = 10_000;

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
