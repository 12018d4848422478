package no.hials.crosscom.cli.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Composite;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GraphicsConfiguration;
import java.awt.Image;
import java.awt.Paint;
import java.awt.Polygon;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.font.FontRenderContext;
import java.awt.font.GlyphVector;
import java.awt.geom.AffineTransform;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.PathIterator;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.awt.image.BufferedImageOp;
import java.awt.image.ImageObserver;
import java.awt.image.RenderedImage;
import java.awt.image.renderable.RenderableImage;
import java.text.AttributedCharacterIterator;
import java.util.Locale;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Writes shapes that are drawn as SVG. All of its state is that of an image's graphics, on which
 * nothing is drawn.
 *
 * <p>XChart's own way to SVG takes a library under the LGPL. Shapes are all that XChart draws; an
 * image is refused, since the SVG would not be vectors any more.
 */
@SuppressWarnings("NullAway") // the superclass takes and gives null in many places
final class SvgGraphics extends Graphics2D {
  private final Graphics2D state =
      new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
  private final StringBuilder body = new StringBuilder();
  private final StringBuilder clips = new StringBuilder();
  private int clipCount;
  private @Nullable String clipPath;
  private String clipId = "";

  /** Gives all that was drawn. */
  String document(Chart chart, Chart.Size size) {
    StringBuilder description = new StringBuilder();
    for (Panel panel : chart.panels()) {
      description.append(describe(panel)).append('\n');
    }
    return """
        <?xml version="1.0" encoding="UTF-8"?>
        <svg xmlns="http://www.w3.org/2000/svg" width="%1$d" height="%2$d" viewBox="0 0 %1$d %2$d" role="img">
        <title>%3$s</title>
        <desc>%4$s</desc>
        <defs>
        %5$s</defs>
        %6$s</svg>
        """
        .formatted(
            size.width(),
            size.height(),
            escape(chart.title()),
            escape(description.toString().strip()),
            clips,
            body);
  }

  private static String describe(Panel panel) {
    StringBuilder text = new StringBuilder(panel.title());
    text.append(text.isEmpty() ? "" : ": ").append(panel.y().label());
    text.append(" over ").append(panel.x().label());
    String separator = "; ";
    for (Series series : panel.series()) {
      if (!series.name().isEmpty()) {
        text.append(separator).append(series.name());
        separator = ", ";
      }
    }
    return text.toString();
  }

  private static String escape(String text) {
    StringBuilder escaped = new StringBuilder();
    text.codePoints()
        .forEach(
            c -> {
              switch (c) {
                case '&' -> escaped.append("&amp;");
                case '<' -> escaped.append("&lt;");
                case '>' -> escaped.append("&gt;");
                case '\n' -> escaped.append('\n');
                default ->
                    // XML has no way to write control characters and halves of pairs
                    escaped.appendCodePoint(
                        c < 0x20 || (c >= 0xD800 && c < 0xE000) || (c >= 0xFFFE && c <= 0xFFFF)
                            ? 0xFFFD
                            : c);
              }
            });
    return escaped.toString();
  }

  // what is drawn

  @Override
  public void fill(Shape shape) {
    begin(shape, getTransform());
    body.append("\" fill=\"");
    color("fill");
    body.append("/>\n");
  }

  @Override
  public void draw(Shape shape) {
    if (!(getStroke() instanceof BasicStroke stroke)) {
      fill(getStroke().createStrokedShape(shape));
      return;
    }
    begin(shape, getTransform());
    body.append("\" fill=\"none\" stroke=\"");
    color("stroke");
    body.append(" stroke-width=\"").append(number(stroke.getLineWidth())).append('"');
    if (stroke.getEndCap() != BasicStroke.CAP_BUTT) {
      boolean round = stroke.getEndCap() == BasicStroke.CAP_ROUND;
      body.append(round ? " stroke-linecap=\"round\"" : " stroke-linecap=\"square\"");
    }
    if (stroke.getLineJoin() != BasicStroke.JOIN_MITER) {
      boolean round = stroke.getLineJoin() == BasicStroke.JOIN_ROUND;
      body.append(round ? " stroke-linejoin=\"round\"" : " stroke-linejoin=\"bevel\"");
    }
    if (stroke.getDashArray() != null) {
      body.append(" stroke-dasharray=\"");
      for (float dash : stroke.getDashArray()) {
        body.append(number(dash)).append(' ');
      }
      body.setCharAt(body.length() - 1, '"');
    }
    body.append("/>\n");
  }

  private void begin(Shape shape, AffineTransform transform) {
    body.append("<path");
    if (!clip().isEmpty()) {
      body.append(" clip-path=\"url(#").append(clip()).append(")\"");
    }
    body.append(" d=\"");
    path(body, shape.getPathIterator(transform));
  }

  /** Writes the colour behind the attribute's name and quote, and the opacity if it is not full. */
  private void color(String attribute) {
    Color color = getColor();
    body.append(String.format(Locale.ROOT, "#%06X\"", color.getRGB() & 0xFFFFFF));
    if (color.getAlpha() < 255) {
      body.append(' ').append(attribute).append("-opacity=\"");
      body.append(number(color.getAlpha() / 255.0)).append('"');
    }
  }

  /**
   * Gives the id of the clip that holds, which is written when it is new; empty if there is none.
   */
  private String clip() {
    Shape clip = state.getClip();
    if (clip == null) {
      return "";
    }
    StringBuilder path = new StringBuilder();
    path(path, clip.getPathIterator(getTransform()));
    if (!path.toString().equals(clipPath)) {
      clipPath = path.toString();
      clipId = "clip" + ++clipCount;
      clips.append("<clipPath id=\"").append(clipId).append("\"><path d=\"");
      clips.append(path).append("\"/></clipPath>\n");
    }
    return clipId;
  }

  private static void path(StringBuilder out, PathIterator path) {
    double[] c = new double[6];
    for (; !path.isDone(); path.next()) {
      int segment = path.currentSegment(c);
      int count =
          switch (segment) {
            case PathIterator.SEG_MOVETO -> numbers(out, 'M', 2);
            case PathIterator.SEG_LINETO -> numbers(out, 'L', 2);
            case PathIterator.SEG_QUADTO -> numbers(out, 'Q', 4);
            case PathIterator.SEG_CUBICTO -> numbers(out, 'C', 6);
            default -> numbers(out, 'Z', 0);
          };
      for (int i = 0; i < count; i++) {
        out.append(i == 0 ? "" : " ").append(number(c[i]));
      }
    }
  }

  private static int numbers(StringBuilder out, char command, int count) {
    out.append(command);
    return count;
  }

  /** Prints a number with two digits behind the point at most: a hundredth of a pixel. */
  private static String number(double value) {
    long hundredths = Math.round(value * 100);
    return hundredths % 100 == 0
        ? Long.toString(hundredths / 100)
        : Double.toString(hundredths / 100.0);
  }

  @Override
  public void drawLine(int x1, int y1, int x2, int y2) {
    draw(new Line2D.Double(x1, y1, x2, y2));
  }

  @Override
  public void fillRect(int x, int y, int width, int height) {
    fill(new Rectangle2D.Double(x, y, width, height));
  }

  @Override
  public void clearRect(int x, int y, int width, int height) {
    Color color = getColor();
    setColor(getBackground());
    fillRect(x, y, width, height);
    setColor(color);
  }

  @Override
  public void drawRoundRect(int x, int y, int width, int height, int arcWidth, int arcHeight) {
    draw(new RoundRectangle2D.Double(x, y, width, height, arcWidth, arcHeight));
  }

  @Override
  public void fillRoundRect(int x, int y, int width, int height, int arcWidth, int arcHeight) {
    fill(new RoundRectangle2D.Double(x, y, width, height, arcWidth, arcHeight));
  }

  @Override
  public void drawOval(int x, int y, int width, int height) {
    draw(new Ellipse2D.Double(x, y, width, height));
  }

  @Override
  public void fillOval(int x, int y, int width, int height) {
    fill(new Ellipse2D.Double(x, y, width, height));
  }

  @Override
  public void drawArc(int x, int y, int width, int height, int startAngle, int arcAngle) {
    draw(new Arc2D.Double(x, y, width, height, startAngle, arcAngle, Arc2D.OPEN));
  }

  @Override
  public void fillArc(int x, int y, int width, int height, int startAngle, int arcAngle) {
    fill(new Arc2D.Double(x, y, width, height, startAngle, arcAngle, Arc2D.PIE));
  }

  @Override
  public void drawPolyline(int[] xPoints, int[] yPoints, int points) {
    Path2D line = new Path2D.Double();
    for (int i = 0; i < points; i++) {
      if (i == 0) {
        line.moveTo(xPoints[i], yPoints[i]);
      } else {
        line.lineTo(xPoints[i], yPoints[i]);
      }
    }
    draw(line);
  }

  @Override
  public void drawPolygon(int[] xPoints, int[] yPoints, int points) {
    draw(new Polygon(xPoints, yPoints, points));
  }

  @Override
  public void fillPolygon(int[] xPoints, int[] yPoints, int points) {
    fill(new Polygon(xPoints, yPoints, points));
  }

  @Override
  public void drawString(String text, int x, int y) {
    drawString(text, (float) x, (float) y);
  }

  @Override
  public void drawString(String text, float x, float y) {
    drawGlyphVector(getFont().createGlyphVector(getFontRenderContext(), text), x, y);
  }

  @Override
  public void drawString(AttributedCharacterIterator iterator, int x, int y) {
    drawString(iterator, (float) x, (float) y);
  }

  @Override
  public void drawString(AttributedCharacterIterator iterator, float x, float y) {
    new java.awt.font.TextLayout(iterator, getFontRenderContext()).draw(this, x, y);
  }

  @Override
  public void drawGlyphVector(GlyphVector glyphs, float x, float y) {
    fill(glyphs.getOutline(x, y));
  }

  // images

  private static UnsupportedOperationException noImages() {
    return new UnsupportedOperationException("an image would not be vectors in the SVG");
  }

  @Override
  public boolean drawImage(Image image, AffineTransform transform, ImageObserver observer) {
    throw noImages();
  }

  @Override
  public void drawImage(BufferedImage image, BufferedImageOp op, int x, int y) {
    throw noImages();
  }

  @Override
  public void drawRenderedImage(RenderedImage image, AffineTransform transform) {
    throw noImages();
  }

  @Override
  public void drawRenderableImage(RenderableImage image, AffineTransform transform) {
    throw noImages();
  }

  @Override
  public boolean drawImage(Image image, int x, int y, ImageObserver observer) {
    throw noImages();
  }

  @Override
  public boolean drawImage(
      Image image, int x, int y, int width, int height, ImageObserver observer) {
    throw noImages();
  }

  @Override
  public boolean drawImage(Image image, int x, int y, Color background, ImageObserver observer) {
    throw noImages();
  }

  @Override
  public boolean drawImage(
      Image image, int x, int y, int width, int height, Color background, ImageObserver observer) {
    throw noImages();
  }

  @Override
  public boolean drawImage(
      Image image,
      int dx1,
      int dy1,
      int dx2,
      int dy2,
      int sx1,
      int sy1,
      int sx2,
      int sy2,
      ImageObserver observer) {
    throw noImages();
  }

  @Override
  public boolean drawImage(
      Image image,
      int dx1,
      int dy1,
      int dx2,
      int dy2,
      int sx1,
      int sy1,
      int sx2,
      int sy2,
      Color background,
      ImageObserver observer) {
    throw noImages();
  }

  @Override
  public void copyArea(int x, int y, int width, int height, int dx, int dy) {
    throw noImages();
  }

  // the state

  @Override
  public Graphics create() {
    throw new UnsupportedOperationException("an SVG has one graphics");
  }

  @Override
  public void dispose() {
    state.dispose();
  }

  @Override
  public boolean hit(Rectangle rectangle, Shape shape, boolean onStroke) {
    return state.hit(rectangle, shape, onStroke);
  }

  @Override
  public GraphicsConfiguration getDeviceConfiguration() {
    return state.getDeviceConfiguration();
  }

  @Override
  public void setComposite(Composite composite) {
    state.setComposite(composite);
  }

  @Override
  public Composite getComposite() {
    return state.getComposite();
  }

  @Override
  public void setPaint(Paint paint) {
    state.setPaint(paint);
  }

  @Override
  public Paint getPaint() {
    return state.getPaint();
  }

  @Override
  public void setStroke(Stroke stroke) {
    state.setStroke(stroke);
  }

  @Override
  public Stroke getStroke() {
    return state.getStroke();
  }

  @Override
  public void setColor(Color color) {
    state.setColor(color);
  }

  @Override
  public Color getColor() {
    return state.getColor();
  }

  @Override
  public void setBackground(Color color) {
    state.setBackground(color);
  }

  @Override
  public Color getBackground() {
    return state.getBackground();
  }

  @Override
  public void setPaintMode() {
    state.setPaintMode();
  }

  @Override
  public void setXORMode(Color color) {
    state.setXORMode(color);
  }

  @Override
  public void setFont(Font font) {
    state.setFont(font);
  }

  @Override
  public Font getFont() {
    return state.getFont();
  }

  @Override
  public FontMetrics getFontMetrics(Font font) {
    return state.getFontMetrics(font);
  }

  @Override
  public FontRenderContext getFontRenderContext() {
    return state.getFontRenderContext();
  }

  @Override
  public void setRenderingHint(RenderingHints.Key key, Object value) {
    state.setRenderingHint(key, value);
  }

  @Override
  public Object getRenderingHint(RenderingHints.Key key) {
    return state.getRenderingHint(key);
  }

  @Override
  public void setRenderingHints(Map<?, ?> hints) {
    state.setRenderingHints(hints);
  }

  @Override
  public void addRenderingHints(Map<?, ?> hints) {
    state.addRenderingHints(hints);
  }

  @Override
  public RenderingHints getRenderingHints() {
    return state.getRenderingHints();
  }

  @Override
  public void translate(int x, int y) {
    state.translate(x, y);
  }

  @Override
  public void translate(double x, double y) {
    state.translate(x, y);
  }

  @Override
  public void rotate(double theta) {
    state.rotate(theta);
  }

  @Override
  public void rotate(double theta, double x, double y) {
    state.rotate(theta, x, y);
  }

  @Override
  public void scale(double x, double y) {
    state.scale(x, y);
  }

  @Override
  public void shear(double x, double y) {
    state.shear(x, y);
  }

  @Override
  public void transform(AffineTransform transform) {
    state.transform(transform);
  }

  @Override
  public void setTransform(AffineTransform transform) {
    state.setTransform(transform);
  }

  @Override
  public AffineTransform getTransform() {
    return state.getTransform();
  }

  @Override
  public void clip(Shape shape) {
    state.clip(shape);
  }

  @Override
  public void clipRect(int x, int y, int width, int height) {
    state.clipRect(x, y, width, height);
  }

  @Override
  public void setClip(int x, int y, int width, int height) {
    state.setClip(x, y, width, height);
  }

  @Override
  public void setClip(Shape clip) {
    state.setClip(clip);
  }

  @Override
  public Shape getClip() {
    return state.getClip();
  }

  @Override
  public Rectangle getClipBounds() {
    return state.getClipBounds();
  }
}
