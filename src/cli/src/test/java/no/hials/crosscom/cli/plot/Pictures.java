package no.hials.crosscom.cli.plot;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.w3c.dom.Document;
import org.xml.sax.SAXException;

/** Reads pictures back. */
public final class Pictures {
  private Pictures() {}

  /** Reads a PNG. */
  public static BufferedImage png(Path file) throws IOException {
    return Objects.requireNonNull(ImageIO.read(file.toFile()));
  }

  /** Counts the pixels of each colour, as 0xRRGGBB. */
  public static Map<Integer, Integer> colors(Path png) throws IOException {
    BufferedImage image = png(png);
    Map<Integer, Integer> colors = new HashMap<>();
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 0; x < image.getWidth(); x++) {
        colors.merge(image.getRGB(x, y) & 0xFFFFFF, 1, Integer::sum);
      }
    }
    return colors;
  }

  /** Reads an SVG. */
  public static Document svg(Path file) throws IOException {
    try {
      DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
      factory.setNamespaceAware(true);
      return factory.newDocumentBuilder().parse(file.toFile());
    } catch (ParserConfigurationException | SAXException e) {
      throw new IOException(e);
    }
  }

  /** Gives the title of an SVG and what it says of its panels. */
  public static String texts(Path svg) throws IOException {
    Document document = svg(svg);
    return document.getElementsByTagName("title").item(0).getTextContent()
        + "\n"
        + document.getElementsByTagName("desc").item(0).getTextContent();
  }
}
