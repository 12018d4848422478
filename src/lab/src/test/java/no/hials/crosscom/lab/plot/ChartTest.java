package no.hials.crosscom.lab.plot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.lab.plot.Series.Style;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.Timeout.ThreadMode;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

class ChartTest {
  private static final int BLUE = 0x0072B2;
  private static final int VERMILION = 0xD55E00;
  private static final Quantity TIME = new Quantity("time", "s");
  private static final Quantity LENGTH = new Quantity("position", "mm");
  private static final Chart.Size SIZE = new Chart.Size(400, 300);

  @TempDir private Path folder;

  private static Chart chart(Series... series) {
    return Chart.stacked(
        "Title & more", List.of(Panel.of("", TIME, LENGTH, Panel.Scale.FREE, List.of(series))));
  }

  private static Series line(String name, double... y) {
    double[] x = new double[y.length];
    for (int i = 0; i < x.length; i++) {
      x[i] = i;
    }
    return Series.of(name, Style.LINE, x, y);
  }

  @Test
  void drawsEachSeriesOfAPngInAColourOfItsOwn() throws IOException {
    Path file = folder.resolve("a.png");

    chart(line("a", 1, 2, 3), line("b", 3, 2, 2)).write(file, SIZE);

    BufferedImage image = Pictures.png(file);
    assertThat(image.getWidth()).isEqualTo(400);
    assertThat(image.getHeight()).isEqualTo(300);
    assertThat(Pictures.colors(file)).containsKeys(BLUE, VERMILION);
  }

  @Test
  void writesShapesAndTextsIntoAnSvg() throws IOException {
    Path file = folder.resolve("a.svg");

    chart(line("$POS_ACT.X", 1, 2, 3)).write(file, SIZE);

    Document svg = Pictures.svg(file);
    Element root = svg.getDocumentElement();
    assertThat(root.getNamespaceURI()).isEqualTo("http://www.w3.org/2000/svg");
    assertThat(root.getAttribute("viewBox")).isEqualTo("0 0 400 300");
    assertThat(root.getAttribute("width")).isEqualTo("400");
    assertThat(root.getAttribute("height")).isEqualTo("300");
    assertThat(svg.getDoctype()).as("what a reader would have to fetch").isNull();
    assertThat(Pictures.texts(file))
        .isEqualTo("Title & more\nposition [mm] over time [s]; $POS_ACT.X");
    assertThat(drawnTexts(svg)).containsExactly("Title & more", "$POS_ACT.X");
    assertThat(svg.getElementsByTagName("image").getLength()).isZero();
    assertThat(lines(svg, BLUE)).hasSize(2);
  }

  @Test
  void keepsWhatXmlCannotWriteOutOfTheSvg() throws IOException {
    Path file = folder.resolve("a.svg");

    chart(line("<a> \u0001 \uD800 b", 1, 2)).write(file, SIZE);

    assertThat(Pictures.texts(file)).endsWith("; <a> \uFFFD \uFFFD b");
    assertThat(drawnTexts(Pictures.svg(file))).contains("<a> \uFFFD \uFFFD b");
  }

  @Test
  void bridgesNoGap() throws IOException {
    Path whole = folder.resolve("whole.svg");
    Path gap = folder.resolve("gap.svg");

    chart(line("", 1, 2, 3, 4)).write(whole, SIZE);
    chart(line("", 1, 2, Double.NaN, 3, 4)).write(gap, SIZE);

    assertThat(moves(lines(Pictures.svg(whole), BLUE).get(0))).isEqualTo(1);
    assertThat(moves(lines(Pictures.svg(gap), BLUE).get(0))).isEqualTo(2);
  }

  @Test
  void showsAPointBetweenTwoGapsAsADot() throws IOException {
    Path file = folder.resolve("a.png");

    chart(line("", Double.NaN, 2, Double.NaN, 3, Double.NaN)).write(file, SIZE);

    assertThat(Pictures.colors(file).get(BLUE)).isBetween(8, 80);
  }

  @Test
  void drawsAnEmptySeriesAsAnEmptyPanel() throws IOException {
    Path file = folder.resolve("a.png");

    chart(line("nothing", Double.NaN, Double.NaN)).write(file, SIZE);

    assertThat(Pictures.png(file).getWidth()).isEqualTo(400);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1e30    | 1 value beyond 1e15 is not shown",
        "-3.4e38 | 1 value beyond 1e15 is not shown",
        "1e300   | 1 value beyond 1e15 is not shown",
        "Infinity| 1 value without a finite number is not shown"
      })
  @Timeout(value = 60, threadMode = ThreadMode.SEPARATE_THREAD)
  void leavesOutWhatIsTooLargeForAnAxisAndSaysSo(double value, String text) throws IOException {
    Path file = folder.resolve("a.svg");

    chart(line("a", 1, value, 2)).write(file, SIZE);

    assertThat(Pictures.texts(file)).endsWith("; a; " + text);
    assertThat(drawnTexts(Pictures.svg(file))).containsExactly("Title & more", "a", text);
    assertThat(Pictures.texts(file)).doesNotContain("NaN");
  }

  @ParameterizedTest
  @EnumSource
  @Timeout(value = 60, threadMode = ThreadMode.SEPARATE_THREAD)
  void drawsTheLargestNumbersThatItShows(Panel.Scale scale) throws IOException {
    Path file = folder.resolve("a.svg");
    double max = scale == Panel.Scale.FREE ? 2e18 : 1e15;
    double[] x = {-max, max};
    double[] y = {-1e15, 1e15};
    Series series = Series.of("a", Series.Style.LINE, x, y);
    Quantity axis = new Quantity("v", "");

    Chart.stacked("", List.of(Panel.of("", axis, axis, scale, List.of(series)))).write(file, SIZE);

    assertThat(Pictures.texts(file)).doesNotContain("not shown");
  }

  @Test
  @Timeout(value = 60, threadMode = ThreadMode.SEPARATE_THREAD)
  void leavesOutPointsOfAPathThatAreTooLarge() throws IOException {
    Path file = folder.resolve("a.svg");
    double[] x = {1, 2, 1e30, 3};
    double[] y = {1, 2, 3, 4};

    PathCharts.space("", "mm", List.of(Track.of("p", x, y, y)))
        .write(file, new Chart.Size(800, 800));

    assertThat(Pictures.texts(file))
        .contains(
            "from above: Y [mm] over X [mm]; p, start, end; 1 value beyond 1e15 is not shown");
  }

  @Test
  void replacesAPictureByOneThatIsComplete() throws IOException {
    Path file = Files.writeString(folder.resolve("a.svg"), "old");
    Path other = Files.createLink(folder.resolve("link"), file);

    chart(line("a", 1, 2)).write(file, SIZE);

    assertThat(other).as("the old file, which was not written to").hasContent("old");
    assertThat(Pictures.texts(file)).endsWith("; a");
    assertThat(folder.toFile().list()).containsExactlyInAnyOrder("a.svg", "link");
  }

  @Test
  void leavesNoPartOfAPictureThatCannotBeWritten() {
    Path tooLong = folder.resolve("a".repeat(300) + ".svg");

    assertThatThrownBy(() -> chart(line("a", 1, 2)).write(tooLong, SIZE))
        .isInstanceOf(IOException.class);
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void drawsWhatStandsStillInTheMiddle() throws IOException {
    Path file = folder.resolve("a.svg");

    chart(line("", 5, 5, 5)).write(file, SIZE);

    // of a panel that is 254 pixels high
    assertThat(numbers(lines(Pictures.svg(file), BLUE).get(0)).get(1)).isBetween(70.0, 140.0);
  }

  @Test
  void givesBothAxesTheSameScaleWhereAskedTo() throws IOException {
    Path file = folder.resolve("a.svg");
    double[] x = {0, 100, 100, 0, 0};
    double[] y = {0, 0, 100, 100, 0};

    PathCharts.plane("", "square", new Quantity("X", "mm"), new Quantity("Y", "mm"), x, y)
        .write(file, new Chart.Size(600, 300));

    List<Double> numbers = numbers(lines(Pictures.svg(file), BLUE).get(1));
    double width = numbers.get(2) - numbers.get(0);
    double height = numbers.get(3) - numbers.get(5);
    assertThat(width).isGreaterThan(100).isCloseTo(height, within(1));
  }

  @Test
  void drawsPathsInSpaceInFourPanels() throws IOException {
    Path file = folder.resolve("a.svg");
    double[] x = {500, 600, Double.NaN, 600, 500};
    double[] y = {0, 0, Double.NaN, 100, 100};
    double[] z = {800, 850, Double.NaN, 900, 950};

    PathCharts.space("Path", "mm", List.of(Track.of("$POS_ACT", x, y, z)))
        .write(file, new Chart.Size(800, 700));

    assertThat(Pictures.texts(file).lines())
        .containsExactly(
            "Path",
            "from above: Y [mm] over X [mm]; $POS_ACT, start, end",
            "isometric:  over ; its shadow, $POS_ACT, start, end",
            "from the side, along Y: Z [mm] over X [mm]; $POS_ACT, start, end",
            "from the front, along X: Z [mm] over Y [mm]; $POS_ACT, start, end");
  }

  @Test
  void makesAStepOfEachBinOfAHistogram() throws IOException {
    Path file = folder.resolve("a.svg");
    Series bins = Series.histogram("n", 1, 0.5, 2, 4);

    Chart.stacked("", List.of(Panel.of("", TIME, LENGTH, Panel.Scale.FREE, List.of(bins))))
        .write(file, SIZE);

    // from zero up, along, up, along and down to zero
    List<Double> n = numbers(lines(Pictures.svg(file), BLUE).get(1));
    assertThat(n).hasSize(12);
    assertThat(n.get(3) - n.get(1)).isCloseTo((n.get(7) - n.get(1)) / 2, within(0.1));
    assertThat(n.get(11)).isEqualTo(n.get(1));
  }

  @Test
  void givesEveryOneOfFourteenLinesALookOfItsOwn() {
    List<Series> series = new ArrayList<>();
    for (int i = 0; i < 14; i++) {
      series.add(line("s" + i, i, i));
    }

    List<Look> looks = Legend.looks(Panel.of("", TIME, LENGTH, Panel.Scale.FREE, series));

    assertThat(looks.stream().distinct()).hasSize(14);
  }

  @Test
  void wrapsALegendThatIsTooWide() {
    Series a = line("a long name of a series", 1);
    Panel one = Panel.of("", TIME, LENGTH, Panel.Scale.FREE, List.of(a));
    Panel five = Panel.of("", TIME, LENGTH, Panel.Scale.FREE, List.of(a, a, a, a, a));

    assertThat(new Legend(five, 500).height()).isGreaterThan(new Legend(one, 500).height());
    assertThat(new Legend(five, 5000).height()).isEqualTo(new Legend(one, 5000).height());
  }

  @Test
  void refusesASizeThatIsTooSmallForItsPanelsAndSaysHowHighItMustBe() throws IOException {
    Panel panel = Panel.of("p", TIME, LENGTH, Panel.Scale.FREE, List.of(line("a", 1, 2)));
    Chart chart = Chart.stacked("t", List.of(panel, panel, panel));
    Path file = folder.resolve("a.png");

    assertThatThrownBy(() -> chart.write(file, new Chart.Size(400, 200)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "a picture of 400x200 is too small for its 3 panels: it must be at least 494 pixels"
                + " high");
    assertThat(file).doesNotExist();
    chart.write(file, new Chart.Size(400, 494));
    assertThat(Files.size(file)).isPositive();
  }

  @Test
  void drawsTheLinesOfTheSmallestPanelsInTheirPlaces() throws IOException {
    Path file = folder.resolve("a.svg");
    Panel panel = Panel.of("", TIME, LENGTH, Panel.Scale.FREE, List.of(line("", 1, 2)));

    Chart.stacked("t", List.of(panel, panel, panel)).write(file, new Chart.Size(300, 400));

    for (String line : lines(Pictures.svg(file), BLUE)) {
      List<Double> numbers = numbers(line);
      assertThat(numbers.get(1) - numbers.get(3)).isGreaterThan(30);
    }
  }

  @ParameterizedTest
  @CsvSource({"880, 380", "3840, 420", "10000, 380"})
  void drawsTheLinesOfWidePanelsInTheirPlaces(int width, int height) throws IOException {
    Path file = folder.resolve("a.svg");
    Panel panel = Panel.of("", TIME, LENGTH, Panel.Scale.FREE, List.of(line("", 1, 2)));

    Chart.stacked("t", List.of(panel, panel, panel)).write(file, new Chart.Size(width, height));

    List<String> lines = lines(Pictures.svg(file), BLUE);
    assertThat(lines).hasSize(3);
    for (String line : lines) {
      List<Double> numbers = numbers(line);
      assertThat(numbers.get(1) - numbers.get(3)).isGreaterThan(30);
      assertThat(numbers.get(2) - numbers.get(0)).isGreaterThan(width * 0.9);
    }
  }

  @ParameterizedTest
  @EnumSource(names = "VIEW", mode = EnumSource.Mode.EXCLUDE)
  void refusesASizeThatIsTooNarrowAndSaysHowWideItMustBe(Panel.Scale scale) throws IOException {
    double[] large = {-1e15, 1e15};
    Series series = Series.of("a", Style.LINE, new double[] {0, 1}, large);
    Panel panel = Panel.of("p", TIME, LENGTH, scale, List.of(series));
    Chart chart = new Chart("t", List.of(panel, panel, panel), 3);
    Path file = folder.resolve("a.png");

    String message =
        catchThrowableOfType(
                IllegalArgumentException.class, () -> chart.write(file, new Chart.Size(300, 300)))
            .getMessage();

    assertThat(message)
        .matches("a picture of 300x300 is too small .* must be at least \\d+ pixels wide");
    int needed = Integer.parseInt(message.replaceAll(".* least (\\d+) .*", "$1"));
    chart.write(file, new Chart.Size(needed, 300));
    assertThat(Pictures.png(file).getWidth()).isEqualTo(needed);
  }

  @Test
  void refusesAFormatItDoesNotKnow() {
    assertThatThrownBy(() -> chart(line("a", 1)).write(folder.resolve("a.gif"), SIZE))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("the name of a picture must end with .png or .svg, is ");
  }

  @Test
  void refusesSeriesWithMoreXThanY() {
    double[] two = {1, 2};
    double[] one = {1};

    assertThatThrownBy(() -> Series.of("a", Style.LINE, two, one))
        .hasMessage("a series must have as many x as y, has 2 and 1");
  }

  @Test
  void drawsTheSameForPngAndSvg() throws IOException {
    Path png = folder.resolve("a.png");
    Series area = Series.histogram("n", 0, 1, 1, 2, 3);
    Series points = Series.of("p", Style.POINTS, new double[] {1, 2}, new double[] {1, 2});

    chart(area, points).write(png, SIZE);
    chart(area, points).write(folder.resolve("a.svg"), SIZE);

    Map<Integer, Integer> colors = Pictures.colors(png);
    assertThat(colors.get(VERMILION)).isGreaterThan(3 * 20);
    Document svg = Pictures.svg(folder.resolve("a.svg"));
    // two points and the one in the legend
    assertThat(Pictures.shapes(svg, "fill", new Color(VERMILION))).hasSize(3);
  }

  @Test
  void drawsAGuideDashed() throws IOException {
    Path file = folder.resolve("a.svg");
    Series guide = Series.of("", Style.GUIDE, new double[] {0, 1}, new double[] {0, 1});

    chart(guide).write(file, SIZE);

    List<Element> lines = Pictures.shapes(Pictures.svg(file), "stroke", new Color(0x666666));
    assertThat(lines).hasSize(1);
    assertThat(Pictures.inherited(lines.get(0), "stroke-dasharray")).isEqualTo("7,4");
  }

  private static org.assertj.core.data.Offset<Double> within(double offset) {
    return org.assertj.core.data.Offset.offset(offset);
  }

  /** Returns the paths that are drawn in a colour: the one in the legend, then the series. */
  private static List<String> lines(Document svg, int color) {
    return Pictures.shapes(svg, "stroke", new Color(color)).stream()
        .filter(shape -> shape.getTagName().equals("path"))
        .map(path -> path.getAttribute("d"))
        .toList();
  }

  private static List<String> drawnTexts(Document svg) {
    List<String> texts = new ArrayList<>();
    NodeList elements = svg.getElementsByTagName("text");
    for (int i = 0; i < elements.getLength(); i++) {
      texts.add(elements.item(i).getTextContent());
    }
    return texts;
  }

  private static long moves(String path) {
    return path.chars().filter(c -> c == 'M').count();
  }

  private static List<Double> numbers(String path) {
    List<Double> numbers = new ArrayList<>();
    for (String number : path.replaceAll("[MLZ]", " ").strip().split(" +", -1)) {
      numbers.add(Double.valueOf(number));
    }
    return numbers;
  }
}
