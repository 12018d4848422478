package no.hials.crosscom.lab.plot;

import java.awt.Dimension;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.stream.Collectors;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.transform.OutputKeys;
import javax.xml.transform.Transformer;
import javax.xml.transform.TransformerException;
import javax.xml.transform.TransformerFactory;
import javax.xml.transform.dom.DOMSource;
import javax.xml.transform.stream.StreamResult;
import org.apache.batik.svggen.SVGGeneratorContext;
import org.apache.batik.svggen.SVGGraphics2D;
import org.w3c.dom.Document;
import org.w3c.dom.Element;

/**
 * Writes a chart as SVG. Batik creates the elements and the JDK writes the file, because Batik's
 * own writer adds a DTD, which readers would fetch from the network.
 */
final class SvgWriter {
  private static final String NAMESPACE = "http://www.w3.org/2000/svg";

  /** Digits after the point: a hundredth of a pixel. */
  private static final int PRECISION = 2;

  private SvgWriter() {}

  static byte[] draw(Chart chart, Chart.Size size) throws IOException {
    try {
      Document document =
          DocumentBuilderFactory.newDefaultInstance()
              .newDocumentBuilder()
              .getDOMImplementation()
              .createDocument(NAMESPACE, "svg", null);
      Element root = draw(chart, document, size);
      root.setAttribute("viewBox", "0 0 " + size.width() + " " + size.height());
      root.setAttribute("role", "img");
      describe(root, "desc", description(chart));
      describe(root, "title", chart.title());
      ByteArrayOutputStream bytes = new ByteArrayOutputStream();
      Transformer transformer = TransformerFactory.newDefaultInstance().newTransformer();
      transformer.setOutputProperty(OutputKeys.INDENT, "yes");
      transformer.transform(new DOMSource(root), new StreamResult(bytes));
      return bytes.toByteArray();
    } catch (ParserConfigurationException | TransformerException e) {
      throw new IOException(e);
    }
  }

  private static Element draw(Chart chart, Document document, Chart.Size size)
      throws NoFontsException {
    SVGGeneratorContext context = SVGGeneratorContext.createDefault(document);
    context.setPrecision(PRECISION);
    SVGGraphics2D g = new SVGGraphics2D(context, false);
    g.setSVGCanvasSize(new Dimension(size.width(), size.height()));
    try {
      ChartPainter.paint(chart, g, size);
      return g.getRoot();
    } finally {
      g.dispose();
    }
  }

  private static void describe(Element root, String name, String text) {
    Element element = root.getOwnerDocument().createElementNS(NAMESPACE, name);
    element.setTextContent(Typeface.printable(text));
    root.insertBefore(element, root.getFirstChild());
  }

  private static String description(Chart chart) {
    return chart.panels().stream().map(SvgWriter::description).collect(Collectors.joining("\n"));
  }

  private static String description(Panel panel) {
    String title = panel.title().isEmpty() ? "" : panel.title() + ": ";
    String names =
        panel.series().stream()
            .map(Series::name)
            .filter(name -> !name.isEmpty())
            .collect(Collectors.joining(", "));
    String axes = panel.y().label() + " over " + panel.x().label();
    String leftOut = panel.leftOut();
    return title
        + axes
        + (names.isEmpty() ? "" : "; " + names)
        + (leftOut.isEmpty() ? "" : "; " + leftOut);
  }
}
