package no.hials.crosscom.lab.plot;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** The formats of picture files. */
enum Format {
  PNG {
    @Override
    void write(Chart chart, Path file, Chart.Size size) throws IOException {
      BufferedImage image = image(size);
      Graphics2D g = image.createGraphics();
      try {
        ChartPainter.paint(chart, g, size);
      } finally {
        g.dispose();
      }
      // ImageIO's own stream has a shutdown hook, which cannot be added after Ctrl-C
      try (OutputStream out = Files.newOutputStream(file);
          ImageOutputStream memory = new MemoryCacheImageOutputStream(out)) {
        ImageIO.write(image, "png", memory);
      }
    }
  },

  SVG {
    @Override
    void write(Chart chart, Path file, Chart.Size size) throws IOException {
      SvgWriter.write(chart, file, size);
    }
  };

  static {
    // no display is needed, and a DISPLAY that does not exist would be an error
    if (System.getProperty("java.awt.headless") == null) {
      System.setProperty("java.awt.headless", "true");
    }
  }

  /** Draws a chart and writes it to a file. */
  abstract void write(Chart chart, Path file, Chart.Size size) throws IOException;

  static Format of(Path file) {
    String name = file.toString().toLowerCase(Locale.ROOT);
    if (name.endsWith(".png")) {
      return PNG;
    }
    if (name.endsWith(".svg")) {
      return SVG;
    }
    throw new IllegalArgumentException(
        "the name of a picture must end with .png or .svg, is " + file);
  }

  static BufferedImage image(Chart.Size size) {
    return new BufferedImage(size.width(), size.height(), BufferedImage.TYPE_INT_RGB);
  }
}
