package no.hials.crosscom.cli.lab;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Stream;
import no.hials.crosscom.cell.recording.OutputException;
import no.hials.crosscom.cli.base.ConsoleCommand;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.LiveLine;
import no.hials.crosscom.cli.base.LocalFiles;
import no.hials.crosscom.cli.base.StopSignal;
import no.hials.crosscom.cli.base.StoppedException;
import no.hials.crosscom.cli.base.Table;
import no.hials.crosscom.cli.base.Terminal;
import no.hials.crosscom.control.ControlRefusedException;
import no.hials.crosscom.control.LoopStatistics;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.lab.experiment.Experiment;
import no.hials.crosscom.lab.experiment.ExperimentResult;
import no.hials.crosscom.lab.experiment.Run;
import no.hials.crosscom.lab.plot.Chart;
import no.hials.crosscom.mock.Latency;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code experiment NAME...}. */
@Command(
    name = "experiment",
    description = {
      "Repeats the experiments of the papers on a simulated robot. The robot follows a figure by"
          + " the programs in krl, and the desired, sent and measured positions are drawn.",
      "It never connects to a real robot."
    },
    footer = {
      "",
      "The robot is a KR 6 R900 sixx that runs a program of krl (actuator.src or"
          + " ext_move_axis.src), with the watchdog krl/jov_sps.sub. It is simulated in real time"
          + " in a separate process. Other programs on this computer can disturb the period of the"
          + " loop.",
      "",
      "The exit code is 1 if a limit or an error stopped the robot. Ctrl-C ends an experiment; its"
          + " files then have what was measured until then, and the exit code is 130.",
      "",
      "CSV: NAME.csv has one line per cycle, NAME-figures.csv the results. An experiment with"
          + " two loops has such files for each.",
      "",
      "Examples:",
      "  jopenshowvar experiment list",
      "  jopenshowvar experiment position-circle",
      "  jopenshowvar experiment line-dls --csv --format svg --out results",
      "  jopenshowvar experiment velocity-square --lap 5s --latency 1ms",
      "  jopenshowvar experiment all --out results",
      "  jopenshowvar experiment endurance --for 10m"
    })
public final class ExperimentCommand extends ConsoleCommand {
  private static final String LIST = "list";
  private static final String ALL = "all";
  private static final String ENDURANCE = "endurance";
  private static final int WIDTH = 1000;

  @Parameters(
      arity = "1..*",
      paramLabel = "NAME",
      completionCandidates = Names.class,
      description =
          "The experiment. 'list' lists all names; 'all' runs all except endurance, which takes"
              + " 10 minutes.")
  private List<String> names = new ArrayList<>();

  @Option(
      names = {"-o", "--out"},
      paramLabel = "FOLDER",
      description =
          "The folder for the files, created if necessary. Default: the current" + " folder.")
  private Path folder = Path.of("");

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      completionCandidates = Formats.class,
      description = "Format of the picture, png or svg. Default: png.")
  private String format = "png";

  @Option(names = "--csv", description = "Write CSV files next to the picture.")
  private boolean csv;

  @Option(
      names = {"-y", "--yes"},
      description = "Overwrite existing files.")
  private boolean yes;

  @Mixin private PictureOptions picture = new PictureOptions();

  @Option(
      names = "--for",
      paramLabel = "TIME",
      description = "Duration. Default: 10s, or 10m for endurance.")
  private @Nullable Duration length;

  @Option(
      names = "--lap",
      paramLabel = "TIME",
      description = "Time for one lap of the figure. Default: 10s.")
  private @Nullable Duration lap;

  @Option(
      names = "--period",
      paramLabel = "TIME",
      description = "Period of the loop, 4ms to 1s. Default: 20ms, or 12ms for endurance.")
  private @Nullable Duration period;

  @Option(
      names = "--step",
      paramLabel = "TIME",
      description =
          "Assumed time of the robot's program for one increment, 4ms to 1s. Default: 12ms. A"
              + " longer time means larger increments.")
  private @Nullable Duration step;

  @Option(
      names = "--latency",
      paramLabel = "LATENCY",
      description =
          "Latency of the simulated controller, see 'mock --help'. Default: krc4-2014, or krc4"
              + " for endurance.")
  private @Nullable String latency;

  /** The names of the experiments. */
  static final class Names implements Iterable<String> {
    @Override
    public Iterator<String> iterator() {
      return Stream.concat(Stream.of(LIST, ALL), Experiment.all().stream().map(Experiment::name))
          .iterator();
    }
  }

  /** The forms of pictures. */
  static final class Formats implements Iterable<String> {
    @Override
    public Iterator<String> iterator() {
      return List.of("png", "svg").iterator();
    }
  }

  @Override
  public ExitCode run() throws IOException {
    if (names.contains(LIST)) {
      if (names.size() > 1) {
        throw wrongUsage("list excludes other names");
      }
      Table table = Table.ofValues();
      Experiment.all().forEach(each -> table.add(each.name(), each.description()));
      table.print(console());
      return ExitCode.DONE;
    }
    Set<Experiment> chosen = chosen();
    checkOptions();
    try {
      Files.createDirectories(folder);
    } catch (FileAlreadyExistsException e) {
      throw new OutputException(folder.toString(), new IOException("it is not a folder", e));
    } catch (IOException e) {
      throw new OutputException(folder.toString(), e);
    }
    if (!Files.isWritable(folder)) { // before the run, which may take ten minutes
      throw new OutputException(folder.toString(), new AccessDeniedException(folder.toString()));
    }
    for (Experiment each : chosen) {
      PictureOptions.check(this, pictureOf(each), yes);
      for (String loop : csv ? each.loops() : List.<String>of()) {
        LocalFiles.checkNew(csvOf(each, loop), yes);
        LocalFiles.checkNew(figuresOf(each, loop), yes);
      }
    }
    ExitCode worst = ExitCode.DONE;
    try (StopSignal stop = new StopSignal()) {
      for (Experiment each : chosen) {
        stop.check();
        worst = worst.orWorse(run(each, stop));
      }
    }
    return worst;
  }

  private Set<Experiment> chosen() {
    Set<Experiment> chosen = new LinkedHashSet<>();
    List<Experiment> all = Experiment.all();
    for (String name : names) {
      List<Experiment> found =
          all.stream()
              .filter(
                  each ->
                      name.equals(ALL)
                          ? !each.name().equals(ENDURANCE)
                          : each.name().equalsIgnoreCase(name))
              .toList();
      if (found.isEmpty()) {
        throw wrongUsage("unknown experiment: " + name + "; see 'experiment list'");
      }
      chosen.addAll(found);
    }
    return chosen;
  }

  private void checkOptions() {
    if (!format.equals("png") && !format.equals("svg")) {
      throw wrongUsage("--format must be png or svg, is " + format);
    }
    checkCycle("--period", period);
    checkCycle("--step", step);
    if (latency != null) {
      argument("--latency", latency, text -> Latency.parse(text, 1));
    }
  }

  private void checkCycle(String option, @Nullable Duration time) {
    if (time != null && (time.toMillis() < 4 || time.toMillis() > 1000)) {
      throw wrongUsage(option + " must be 4ms to 1s, is " + time.toMillis() + "ms");
    }
  }

  private Path pictureOf(Experiment experiment) {
    return folder.resolve(experiment.name() + "." + format);
  }

  private Path csvOf(Experiment experiment, String loop) {
    return folder.resolve(name(experiment, loop) + ".csv");
  }

  private Path figuresOf(Experiment experiment, String loop) {
    return folder.resolve(name(experiment, loop) + "-figures.csv");
  }

  private Experiment.Settings settings(Experiment experiment) {
    Experiment.Settings usual = experiment.usual();
    return new Experiment.Settings(
        length == null ? usual.length() : length,
        lap == null ? usual.lap() : lap,
        period == null ? usual.period() : period,
        step == null ? usual.step() : step,
        latency == null ? usual.latency() : latency);
  }

  private ExitCode run(Experiment experiment, StopSignal stop) throws IOException {
    ExperimentResult outcome;
    try (Progress progress = new Progress(experiment.name(), stop)) {
      outcome = experiment.run(settings(experiment), progress).orElseThrow(StoppedException::new);
    } catch (ControlRefusedException e) {
      console().failure(experiment.name() + ": ", e, isVerbose());
      return ExitCode.REFUSED;
    }
    // write all files first: printing ends the command if stdout is closed
    List<Path> files = csv ? writeCsv(experiment, outcome) : new ArrayList<>();
    files.add(pictureOf(experiment));
    picture.write(
        this, outcome.chart(), pictureOf(experiment), new Chart.Size(WIDTH, outcome.height()));
    boolean stopped =
        outcome.runs().size() < experiment.loops().size()
            || outcome.runs().stream().anyMatch(run -> run.end().kind() == StopKind.ASKED);
    print(experiment, outcome, stopped);
    files.forEach(file -> console().print("wrote " + file));
    ExitCode code = ExitCode.DONE;
    if (stopped) {
      console().error(experiment.name() + ": stopped; the files have what was measured until then");
      code = ExitCode.STOPPED;
    }
    for (Run run : outcome.runs()) {
      if (!run.end().isPlanned()) {
        console()
            .error(
                name(experiment, run.name()) + ": the robot was stopped: " + run.end().message());
        code = ExitCode.REFUSED;
      }
    }
    return code;
  }

  /** Shows how far an experiment is: on a terminal in a line that changes, else with -v. */
  private final class Progress implements Experiment.CycleObserver, AutoCloseable {
    private final String name;
    private final StopSignal stop;
    private final LiveLine line =
        new LiveLine(console().err(), !isVerbose() && Terminal.showsProgress());

    Progress(String name, StopSignal stop) {
      this.name = name;
      this.stop = stop;
    }

    @Override
    public boolean goesOn(String phase, Duration elapsed, Duration length) {
      String text = name + ": " + phase;
      if (isVerbose() && elapsed.isZero()) {
        console().error(text + (length.isZero() ? "" : ", " + seconds(length)));
      } else if (line.isDue()) {
        line.show(
            length.isZero() ? text : text + ", " + seconds(elapsed) + " of " + seconds(length));
      }
      return !stop.isStopped();
    }

    private static String seconds(Duration time) {
      return String.format(Locale.ROOT, "%.1f s", time.toMillis() / 1e3);
    }

    @Override
    public void close() {
      line.close();
    }
  }

  // what is printed

  private static String name(Experiment experiment, String loop) {
    return experiment.name() + (loop.isEmpty() ? "" : "-" + loop);
  }

  private void print(Experiment experiment, ExperimentResult outcome, boolean stopped) {
    console().print("");
    for (Run run : outcome.runs()) {
      LoopStatistics numbers = run.statistics();
      Table table =
          Table.withTitles(
              name(experiment, run.name()).toUpperCase(Locale.ROOT),
              "MIN",
              "50 %",
              "MEAN",
              "99 %",
              "MAX");
      addTimes(table, "period [ms]", numbers.period());
      addTimes(table, "read [ms]", numbers.read());
      addTimes(table, "write [ms]", numbers.write());
      addTimes(table, "the rest of a cycle [ms]", numbers.own());
      addTimes(table, "delay of the start [ms]", numbers.late());
      table.print(console());
      console()
          .print(
              numbers.cycles()
                  + " cycles, "
                  + numbers.missed()
                  + " more missed ("
                  + numbers.missedByAccess()
                  + " by the accesses alone), "
                  + numbers.saturated()
                  + " increments cut");
    }
    if (!stopped && outcome.runs().stream().allMatch(run -> run.end().isPlanned())) {
      // otherwise they are only of a part, perhaps of a single cycle
      outcome.figures().forEach(figure -> console().print(line(figure)));
    }
  }

  private static String line(ExperimentResult.Figure figure) {
    return figure.name()
        + ": "
        + number(figure)
        + (figure.unit().isEmpty() ? "" : " ")
        + figure.unit();
  }

  private static String number(ExperimentResult.Figure figure) {
    String form = figure.unit().isEmpty() ? "%.0f" : "%.2f";
    return String.format(Locale.ROOT, form, figure.value());
  }

  private static void addTimes(Table table, String name, LoopStatistics.Times times) {
    table.add(
        name,
        millis(times.minimum()),
        millis(times.median()),
        millis(times.mean()),
        millis(times.percentile99()),
        millis(times.maximum()));
  }

  private static String millis(double value) {
    return String.format(Locale.ROOT, "%.2f", value);
  }

  // what is written

  private List<Path> writeCsv(Experiment experiment, ExperimentResult outcome) {
    List<Path> files = new ArrayList<>();
    for (Run run : outcome.runs()) {
      files.add(write(csvOf(experiment, run.name()), run.trace()::writeCsv));
      files.add(
          write(
              figuresOf(experiment, run.name()),
              text -> {
                run.statistics().writeCsv(text);
                writeCsv(outcome.figures(), text);
              }));
    }
    return files;
  }

  private static void writeCsv(List<ExperimentResult.Figure> figures, Appendable text)
      throws IOException {
    for (ExperimentResult.Figure figure : figures) {
      String unit = figure.unit().isEmpty() ? "" : " [" + figure.unit() + "]";
      text.append("\"" + figure.name() + unit + "\"," + number(figure) + "\n");
    }
  }

  /** Writes the contents of a file. */
  @FunctionalInterface
  private interface Contents {
    void writeTo(Appendable text) throws IOException;
  }

  private static Path write(Path file, Contents contents) {
    try (BufferedWriter writer = Files.newBufferedWriter(file)) {
      contents.writeTo(writer);
    } catch (IOException e) {
      throw new OutputException(file.toString(), e);
    }
    return file;
  }
}
