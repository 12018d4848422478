package no.hials.crosscom.lab.plot;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** The formats of picture files. */
enum Format {
  PNG {
    @Override
    byte[] draw(Chart chart, Chart.Size size) throws IOException {
      BufferedImage image = image(size);
      Graphics2D g = image.createGraphics();
      try {
        ChartPainter.paint(chart, g, size);
      } finally {
        g.dispose();
      }
      ByteArrayOutputStream bytes = new ByteArrayOutputStream();
      // ImageIO's own stream has a shutdown hook, which cannot be added after Ctrl-C
      try (ImageOutputStream memory = new MemoryCacheImageOutputStream(bytes)) {
        ImageIO.write(image, "png", memory);
      }
      return bytes.toByteArray();
    }
  },

  SVG {
    @Override
    byte[] draw(Chart chart, Chart.Size size) throws IOException {
      return SvgWriter.draw(chart, size);
    }
  };

  static {
    useNoDisplay();
  }

  /** Lets Java draw without a display, unless the user set the property. */
  static void useNoDisplay() {
    // no display is needed, and a DISPLAY that does not exist would be an error
    if (System.getProperty("java.awt.headless") == null) {
      System.setProperty("java.awt.headless", "true");
    }
  }

  /** Draws a chart, and returns the bytes of the file. */
  abstract byte[] draw(Chart chart, Chart.Size size) throws IOException;

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
