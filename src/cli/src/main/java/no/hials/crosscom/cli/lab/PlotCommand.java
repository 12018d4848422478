package no.hials.crosscom.cli.lab;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import no.hials.crosscom.cli.base.ConsoleCommand;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.lab.plot.Chart;
import no.hials.crosscom.lab.plot.Panel;
import no.hials.crosscom.lab.plot.PathCharts;
import no.hials.crosscom.lab.plot.PlotData;
import no.hials.crosscom.lab.plot.Quantity;
import no.hials.crosscom.lab.plot.Series;
import no.hials.crosscom.lab.plot.Track;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code plot FILE.csv [NAME...]}. */
@Command(
    name = "plot",
    description = {
      "Draws a recording as PNG or SVG: numbers over time with one panel per unit, or with --xy"
          + " and --xyz the path of a position.",
      "Gaps in the recording are gaps in the lines."
    },
    footer = {
      "",
      "Units come from the list of system variables or from the names of fields: X, Y, Z in mm,"
          + " A, B, C and A1 to A6 in degrees. A column can set its unit: 'force [N]'. TRUE is"
          + " drawn as 1 and FALSE as 0; other texts are not drawn.",
      "",
      "Other CSV files can be drawn, too, if the first line has the names of the columns and the"
          + " first column has numbers, which become the horizontal axis.",
      "",
      "Quoting: put names in single quotes.",
      "",
      "Examples:",
      "  jopenshowvar plot run.csv",
      "  jopenshowvar plot run.csv '$POS_ACT' '$OV_PRO' --out over-time.svg",
      "  jopenshowvar plot run.csv --xyz --title 'Path of the tool'",
      "  jopenshowvar plot run.csv --xy '$POS_ACT.X,$POS_ACT.Y' --size 800x800"
    })
public final class PlotCommand extends ConsoleCommand {
  private static final int WIDTH = 1000;
  private static final int PANEL_HEIGHT = 280;
  private static final int MAX_HEIGHT = 4000;

  @Parameters(index = "0", paramLabel = "FILE.csv", description = "The recording.")
  private Path file = Path.of("");

  @Parameters(
      index = "1..*",
      arity = "0..*",
      paramLabel = "NAME",
      description =
          "A column ('$OV_PRO', '$POS_ACT.X'), or all columns of a structure or array"
              + " ('$POS_ACT'). access_ms is the duration of each reading. Default: all columns"
              + " except S and T, and external axes that are always 0.")
  private List<String> names = new ArrayList<>();

  @Option(
      names = "--xy",
      paramLabel = "NAME,NAME",
      description = "Draw the second column over the first one.")
  private @Nullable String xy;

  @Option(
      names = "--xyz",
      description =
          "Draw the path of a position: from above, from two sides, and isometric. NAME is a"
              + " structure with X, Y and Z.")
  private boolean xyz;

  @Option(
      names = "--title",
      paramLabel = "TEXT",
      description = "The title. Default: name and time of the file.")
  private @Nullable String title;

  @Option(
      names = {"-o", "--out"},
      paramLabel = "FILE",
      description = "The picture, .png or .svg. Default: FILE.png.")
  private @Nullable Path out;

  @Mixin private PictureOptions picture = new PictureOptions();

  @Option(
      names = {"-y", "--yes"},
      description = "Overwrite an existing picture.")
  private boolean yes;

  @Override
  public ExitCode run() throws IOException {
    if (xy != null && (xyz || !names.isEmpty())) {
      throw wrongUsage("--xy goes neither with NAME nor with --xyz");
    }
    Path target = out == null ? pictureNextTo(file) : out;
    PictureOptions.check(this, target, yes);
    PlotData data = PlotData.read(file);
    Chart chart = chart(data);
    int height = xyz ? 800 : xy != null ? 700 : 90 + PANEL_HEIGHT * chart.panels().size();
    picture.write(this, chart, target, new Chart.Size(WIDTH, Math.min(height, MAX_HEIGHT)));
    console().print("wrote " + target);
    return ExitCode.DONE;
  }

  private static Path pictureNextTo(Path csv) {
    String name = String.valueOf(csv.getFileName());
    String stem =
        name.toLowerCase(Locale.ROOT).endsWith(".csv")
            ? name.substring(0, name.length() - ".csv".length())
            : name;
    return csv.resolveSibling(stem + ".png");
  }

  private Chart chart(PlotData data) {
    String heading = title == null ? data.title() : title;
    if (xy != null) {
      return plane(data, heading, xy);
    }
    return xyz ? space(data, heading) : overTime(data, heading);
  }

  // over time

  private Chart overTime(PlotData data, String heading) {
    List<PlotData.Column> chosen = names.isEmpty() ? all(data) : named(data);
    Map<String, List<PlotData.Column>> groups =
        chosen.stream()
            .collect(
                Collectors.groupingBy(PlotCommand::group, LinkedHashMap::new, Collectors.toList()));
    List<Panel> panels = new ArrayList<>();
    groups.values().forEach(columns -> panels.add(panel(data.x(), columns)));
    return Chart.stacked(heading, panels);
  }

  /** Returns the common unit and structure or array of the columns of a panel. */
  private static String group(PlotData.Column column) {
    String variable = variable(column.name());
    return column.unit() + (variable.equals(column.name()) ? "" : " " + variable);
  }

  private static Panel panel(Quantity x, List<PlotData.Column> columns) {
    String unit = columns.get(0).unit();
    Set<String> variables =
        columns.stream().map(c -> variable(c.name())).collect(Collectors.toSet());
    String quantity =
        switch (unit) {
          case "mm" -> "length";
          case "°" -> "angle";
          case "ms" -> "time";
          default -> "value";
        };
    String name = variables.size() == 1 ? variables.iterator().next() : quantity;
    return Panel.of(
        "",
        x,
        new Quantity(name, unit),
        Panel.Scale.FREE,
        columns.stream().map(c -> Series.of(c.name(), Series.Style.LINE, c.x(), c.y())).toList());
  }

  private List<PlotData.Column> all(PlotData data) {
    data.columns().stream()
        .filter(c -> !c.isDrawable() && c.hasNumbers())
        .forEach(c -> console().hint("not drawn: " + c.name() + ", which has also " + c.text()));
    List<PlotData.Column> chosen =
        data.columns().stream()
            .filter(c -> c.isDrawable() && !c.isOnlyIfNamed() && !isIdle(c))
            .toList();
    if (chosen.isEmpty()) {
      throw wrongUsage("nothing in " + file + " can be drawn: it has no numbers");
    }
    return chosen;
  }

  /** Returns whether to leave out a field or element: status, turn, or a missing external axis. */
  private static boolean isIdle(PlotData.Column column) {
    String name = column.name().toUpperCase(Locale.ROOT);
    if (name.matches(".*\\.[ST]")) {
      return true;
    }
    return name.matches(".*(\\.E[1-6]|\\[([7-9]|1[0-2])\\])")
        && Arrays.stream(column.y()).allMatch(value -> value == 0 || Double.isNaN(value));
  }

  private List<PlotData.Column> named(PlotData data) {
    Set<PlotData.Column> chosen = new LinkedHashSet<>();
    for (String name : names) {
      List<PlotData.Column> found = columns(data, name);
      found.stream().filter(c -> found.size() == 1 || !isIdle(c)).forEach(chosen::add);
    }
    return List.copyOf(chosen);
  }

  /** Returns the column of a name, or the columns of a structure or array. */
  private List<PlotData.Column> columns(PlotData data, String name) {
    List<PlotData.Column> exact = data.find(name).map(List::of).orElse(List.of());
    String stem = name.endsWith("[]") ? name.substring(0, name.length() - 2) : name;
    List<PlotData.Column> found =
        exact.isEmpty()
            ? data.columns().stream().filter(c -> isPartOf(c.name(), stem)).toList()
            : exact;
    if (found.isEmpty()) {
      throw unknown(data, name);
    }
    List<PlotData.Column> drawable = found.stream().filter(PlotData.Column::isDrawable).toList();
    if (drawable.isEmpty()) {
      String text = found.get(0).text();
      throw wrongUsage(
          name
              + " cannot be drawn: it has "
              + (text.isEmpty() ? "no numbers" : "texts, such as " + text));
    }
    return drawable;
  }

  private static boolean isPartOf(String column, String stem) {
    return column.length() > stem.length()
        && column.regionMatches(true, 0, stem, 0, stem.length())
        && (column.charAt(stem.length()) == '.' || column.charAt(stem.length()) == '[');
  }

  private RuntimeException unknown(PlotData data, String name) {
    String known =
        data.columns().stream()
            .map(c -> variable(c.name()))
            .distinct()
            .collect(Collectors.joining(" "));
    return wrongUsage("there is no column " + name + " in " + file + ", it has: " + known);
  }

  /** Returns the name before field and index. */
  private static String variable(String column) {
    return column.split("[.\\[]", 2)[0];
  }

  // paths

  private Chart plane(PlotData data, String heading, String pair) {
    // not at the comma of M[2,3]
    String[] two = pair.split(",(?![^\\[]*\\])", -1);
    if (two.length != 2) {
      throw wrongUsage("--xy must be two names with a comma between them, is " + pair);
    }
    PlotData.Column right = one(data, two[0].strip());
    PlotData.Column up = one(data, two[1].strip());
    if (!Arrays.equals(right.x(), up.x())) {
      throw wrongUsage("--xy must be two columns of one robot, are " + pair);
    }
    return PathCharts.plane(
        heading, up.name() + " over " + right.name(), right.axis(), up.axis(), right.y(), up.y());
  }

  private PlotData.Column one(PlotData data, String name) {
    List<PlotData.Column> found = columns(data, name);
    if (found.size() != 1) {
      throw wrongUsage(
          "--xy must be two columns, "
              + name
              + " is "
              + found.size()
              + ", such as "
              + found.get(0).name());
    }
    return found.get(0);
  }

  private Chart space(PlotData data, String heading) {
    List<String> positions = names.isEmpty() ? positions(data) : names;
    if (positions.isEmpty()) {
      throw wrongUsage("--xyz needs a structure with X, Y and Z, " + file + " has none");
    }
    List<Track> tracks = new ArrayList<>();
    for (String position : positions) {
      tracks.add(
          Track.of(
              position,
              one(data, position + ".X").y(),
              one(data, position + ".Y").y(),
              one(data, position + ".Z").y()));
    }
    return PathCharts.space(heading, "mm", tracks);
  }

  private static List<String> positions(PlotData data) {
    return data.columns().stream()
        .map(PlotData.Column::name)
        .filter(name -> name.toUpperCase(Locale.ROOT).endsWith(".X"))
        .map(name -> name.substring(0, name.length() - 2))
        .filter(name -> data.find(name + ".Y").isPresent() && data.find(name + ".Z").isPresent())
        .toList();
  }
}
