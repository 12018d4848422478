package no.hials.crosscom.lab.plot;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
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

  /** Returns the shapes of an SVG that are filled, or whose outlines are drawn, in a colour. */
  public static List<Element> shapes(Document svg, String attribute, Color color) {
    String value = "rgb(%d,%d,%d)".formatted(color.getRed(), color.getGreen(), color.getBlue());
    List<Element> shapes = new ArrayList<>();
    for (String tag : List.of("path", "rect", "circle", "polygon")) {
      NodeList elements = svg.getElementsByTagName(tag);
      for (int i = 0; i < elements.getLength(); i++) {
        Element element = (Element) elements.item(i);
        if (inherited(element, attribute).equals(value)) {
          shapes.add(element);
        }
      }
    }
    return shapes;
  }

  /** Returns an attribute of an element, or else of the nearest group around it that has it. */
  public static String inherited(Element element, String attribute) {
    return element.hasAttribute(attribute) || !(element.getParentNode() instanceof Element parent)
        ? element.getAttribute(attribute)
        : inherited(parent, attribute);
  }

  /** Returns the title of an SVG and what it says of its panels. */
  public static String texts(Path svg) throws IOException {
    Document document = svg(svg);
    return document.getElementsByTagName("title").item(0).getTextContent()
        + "\n"
        + document.getElementsByTagName("desc").item(0).getTextContent();
  }
}
