package no.hials.crosscom.cli.lab;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComUnsupportedException;
import no.hials.crosscom.c3.BenchmarkResult;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.Printable;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.ControllerCommand;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.LocalFiles;
import no.hials.crosscom.cli.base.Robots;
import no.hials.crosscom.cli.base.StopSignal;
import no.hials.crosscom.cli.base.WriteOptions;
import no.hials.crosscom.lab.bench.Bench;
import no.hials.crosscom.lab.bench.BenchAccess;
import no.hials.crosscom.lab.bench.BenchCsv;
import no.hials.crosscom.lab.bench.BenchTally;
import no.hials.crosscom.lab.plot.Chart;
import no.hials.crosscom.mock.Latency;
import no.hials.crosscom.protocol.ServerType;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code bench [NAME...]}. */
@Command(
    name = "bench",
    description =
        "Measures how long reads and writes take, by variable. Each client asks again as soon as it"
            + " has its answer (a closed loop), one variable after the other.",
    footer = {
      "",
      "A variable is written only if --write names it. It gets the value that was read just before,"
          + " so that it keeps its value, unless something else changes it in between. --yes counts"
          + " for such writes and for files that are there already.",
      "",
      "Times are those that a program waits: from the call to the value. An access that failed is"
          + " counted with its kind and is in no time. After a lost connection a client makes a new"
          + " one; it gives up when that fails, or after 10 failures in succession. Ctrl-C ends it,"
          + " and prints what there is.",
      "",
      "C3 Bridge measures reads, too: SERVER is the mean of what a read takes there, without the"
          + " network.",
      "",
      "CSV: seconds since the start, client, access, name, access_ms (empty if it failed), failure."
          + " JSON: a line for each access, times in ms.",
      "",
      "Examples:",
      "  jopenshowvar bench --host 172.31.1.147 --plot times.png",
      "  jopenshowvar bench '$OV_PRO' '$AXIS_ACT' --count 50000 --out times.csv --mock",
      "  jopenshowvar bench --clients 5 --for 30s --mock --latency krc4",
      "  jopenshowvar bench --write MYINT --write MYPOS --mock"
    })
public final class BenchCommand extends ControllerCommand {
  /** Each type once; every controller has them. */
  private static final List<String> USUAL =
      List.of(
          "$OV_PRO",
          "$VEL_ACT",
          "$PERI_RDY",
          "$MODE_OP",
          "$PRO_NAME1[]",
          "$AXIS_ACT",
          "$POS_ACT",
          "$TORQUE_AXIS_ACT[]");

  private static final long USUAL_ROUNDS = 1000;
  private static final int MAX_CLIENTS = 100;
  private static final int MAX_WARM_UP = 1_000_000;
  private static final int WIDTH = 1000;
  private static final int PANEL_HEIGHT = 190;
  private static final int MAX_HEIGHT = 4000;

  /** How long the server may measure by itself for a variable. */
  private static final Duration SERVER_TIME = Duration.ofMillis(500);

  @Parameters(
      arity = "0..*",
      paramLabel = "NAME",
      description =
          "What to read. If nothing is named here and by --write: a variable of each type that every"
              + " controller has.")
  private List<String> names = new ArrayList<>();

  @Option(
      names = "--write",
      paramLabel = "NAME",
      description = "Read this variable, and write back what was read. Can be repeated.")
  private List<String> written = new ArrayList<>();

  @Option(
      names = "--clients",
      paramLabel = "NUMBER",
      description =
          "How many clients ask at the same time, each on a connection of its own; 1 if not given.")
  private int clients = 1;

  @Option(
      names = "--count",
      paramLabel = "NUMBER",
      description = "How often each client does each access; 1000 if not given.")
  private @Nullable Long count;

  @Option(
      names = "--for",
      paramLabel = "TIME",
      description = "How long to measure, instead of --count.")
  private @Nullable Duration length;

  @Option(
      names = "--warm-up",
      paramLabel = "NUMBER",
      description = "How often each client does each access before; 100 if not given.")
  private int warmUp = 100;

  @Option(
      names = "--latency",
      paramLabel = "LATENCY",
      description = "How long a request takes the simulated controller, as in 'mock --latency'.")
  private @Nullable String latency;

  @Option(names = "--histogram", description = "Print a histogram for each access, too.")
  private boolean histogram;

  @Option(
      names = {"-o", "--out"},
      paramLabel = "FILE.csv",
      description = "Write each access into a file.")
  private @Nullable Path out;

  @Option(names = "--plot", paramLabel = "FILE", description = "Draw the histograms, .png or .svg.")
  private @Nullable Path plot;

  @Mixin private PictureOptions pictureOptions = new PictureOptions();

  @Option(names = "--json", order = 5, description = "Print JSON, see below.")
  private boolean json;

  @Mixin private WriteOptions writeOptions = new WriteOptions();

  @Override
  public ExitCode run() throws IOException {
    checkOptions();
    Robot target = target();
    if (!written.isEmpty()) {
      writeOptions
          .permission(console())
          .checkAllowed(target, "write " + String.join(", ", written));
    }
    if (latency == null) {
      try (RobotConnection controller = Robots.open(target, Robot.ONE_SHOT)) {
        return measure(controller);
      }
    }
    if (target.host() != null) {
      throw wrongUsage("--latency goes with --mock");
    }
    Latency times = argument("--latency", latency, text -> Latency.parse(text, 1));
    try (RobotConnection controller =
        Robots.open(target, Robot.ONE_SHOT, cfg -> cfg.latency(times))) {
      return measure(controller);
    }
  }

  private void checkOptions() throws FileException {
    if (count != null && length != null) {
      throw wrongUsage("--count and --for exclude each other");
    }
    checkRange("--clients", clients, 1, MAX_CLIENTS);
    checkRange("--count", count == null ? 1 : count, 1, Long.MAX_VALUE);
    checkRange("--warm-up", warmUp, 0, MAX_WARM_UP);
    checkNames(wanted());
    if (out != null) {
      LocalFiles.checkNew(out, writeOptions.isYes());
    }
    if (plot != null) {
      PictureOptions.check(this, plot, writeOptions.isYes());
    }
  }

  private void checkRange(String option, long value, long min, long max) {
    if (value < min || value > max) {
      String limit = max == Long.MAX_VALUE ? "at least " + min : min + " to " + max;
      throw wrongUsage(option + " must be " + limit + ", is " + value);
    }
  }

  /** Returns the names that the user gave, each once. */
  private Set<String> wanted() {
    Set<String> wanted = new LinkedHashSet<>(names);
    wanted.addAll(written);
    return wanted;
  }

  private ExitCode measure(RobotConnection controller) throws IOException {
    if (!written.isEmpty()) {
      writeOptions.permission(console()).check(controller, "write " + String.join(", ", written));
    }
    ExitCode tried = ExitCode.DONE;
    List<BenchAccess> accesses = new ArrayList<>();
    boolean usual = wanted().isEmpty();
    for (String name : usual ? USUAL : wanted()) {
      try {
        String value = firstRead(controller.client(), name);
        accesses.add(BenchAccess.of(false, name, value));
        if (written.contains(name)) {
          accesses.add(BenchAccess.of(true, name, value));
        }
      } catch (CrossComAccessException e) {
        console().failure(e, isVerbose());
        tried = usual ? tried : ExitCode.REFUSED;
      }
    }
    if (accesses.isEmpty()) {
      return ExitCode.REFUSED;
    }
    Map<String, Double> serverMillis = serverMillis(controller.client(), accesses);
    return tried.orWorse(measure(controller, accesses, serverMillis));
  }

  private String firstRead(CrossComClient client, String name) throws IOException {
    try {
      return client.readText(name);
    } catch (IllegalArgumentException e) {
      throw wrongUsage(String.valueOf(e.getMessage()));
    }
  }

  private ExitCode measure(
      RobotConnection controller, List<BenchAccess> accesses, Map<String, Double> serverMillis)
      throws IOException {
    Long rounds = length == null ? Long.valueOf(count == null ? USUAL_ROUNDS : count) : null;
    try (BenchCsv csv = out == null ? null : new BenchCsv(out)) {
      Bench.BenchListener sink = csv == null ? (nanos, client, access, took, failure) -> {} : csv;
      Bench.BenchPlan plan = new Bench.BenchPlan(accesses, clients, rounds, length, warmUp, sink);
      Bench.Result result;
      try (StopSignal stop = new StopSignal();
          Bench bench = new Bench(plan, controller.client().getConfig())) {
        result = bench.run(stop::isStopped);
      }
      // the measurements are written in any case
      boolean interrupted = Thread.interrupted();
      try {
        report(controller, plan, result, new BenchReport(plan, result, serverMillis));
        return exitCode(result);
      } finally {
        if (interrupted) {
          Thread.currentThread().interrupt();
        }
      }
    }
  }

  private void report(
      RobotConnection controller, Bench.BenchPlan plan, Bench.Result result, BenchReport report)
      throws IOException {
    try {
      print(report);
    } finally {
      // even if stdout is closed
      report.failures().forEach(console()::error);
      result.complaints().forEach(console()::error);
      if (plot != null) {
        int height = Math.min(MAX_HEIGHT, 90 + PANEL_HEIGHT * plan.accesses().size());
        Chart chart = report.chart(title(controller));
        pictureOptions.write(this, chart, plot, new Chart.Size(WIDTH, height));
      }
    }
  }

  private void print(BenchReport report) {
    if (json) {
      report.json().forEach(console()::print);
    } else {
      report.printTable(console());
      (histogram ? report.histograms() : List.<String>of()).forEach(console()::print);
    }
  }

  private String title(RobotConnection controller) {
    String host = controller.robot().host();
    boolean simulated = host == null || latency != null;
    String where =
        simulated
            ? "simulated controller" + (latency == null ? "" : ", latency " + latency)
            : controller.robot().name().isEmpty() ? host : controller.robot().name();
    return "Access times of " + where + ", " + Printable.count(clients, "client");
  }

  private static ExitCode exitCode(Bench.Result result) {
    if (!result.complaints().isEmpty()) {
      return ExitCode.LOST;
    }
    Set<String> kinds = new LinkedHashSet<>();
    result.tallies().forEach(tally -> kinds.addAll(tally.failures().keySet()));
    if (kinds.isEmpty()) {
      return ExitCode.DONE;
    }
    return BenchTally.isRefused(kinds) ? ExitCode.REFUSED : ExitCode.LOST;
  }

  // what C3 Bridge measures

  /** Returns the mean time of a read on the server itself; nothing where it does not measure. */
  private Map<String, Double> serverMillis(CrossComClient client, List<BenchAccess> accesses)
      throws IOException {
    if (client.getServer().type() != ServerType.C3_BRIDGE) {
      return Map.of();
    }
    Map<String, Double> millis = new LinkedHashMap<>();
    for (BenchAccess access : accesses) {
      if (!access.write()) {
        try {
          millis.put(access.name(), serverMillis(client, access.name()));
        } catch (CrossComAccessException | CrossComUnsupportedException e) {
          console().failure(e, isVerbose());
        }
      }
    }
    return millis;
  }

  private static double serverMillis(CrossComClient client, String name) throws IOException {
    // the server answers when it has done all, which must not take too long
    Duration limit = client.getConfig().requestTimeout().dividedBy(4);
    Duration time = limit.compareTo(SERVER_TIME) < 0 ? limit : SERVER_TIME;
    long begin = System.nanoTime();
    client.readText(name);
    long once = Math.max(1, System.nanoTime() - begin);
    long iterations = Math.max(1, Math.min(1000, time.toNanos() / once));
    BenchmarkResult result = client.information().benchmarkRead(iterations, List.of(name));
    return (double) result.duration().toMillis() / iterations;
  }
}
