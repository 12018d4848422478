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
import no.hials.crosscom.CrossComException;
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
import no.hials.crosscom.protocol.MessageType;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code bench [NAME...]}. */
@Command(
    name = "bench",
    description =
        "Measures the times of reads and writes for each variable. Each client sends the next"
            + " request when the previous one is answered (a closed loop).",
    footer = {
      "",
      "Only variables of --write are written, with the value that was read directly before, so"
          + " that they keep their value unless something else changes it at the same time. --yes"
          + " applies to these writes and to existing files.",
      "",
      "A time is measured from the call of the client to its return. Failed accesses are counted"
          + " by kind, and not included in the times. After a lost connection, a client"
          + " reconnects; it gives up if that fails, or after 10 consecutive failures. Ctrl-C"
          + " (SIGINT) or SIGTERM ends the measurement and prints the results so far, with exit"
          + " code 0 if no access failed. The command itself has one more"
          + " connection open, so KUKAVARPROXY, which accepts 10, allows --clients 9.",
      "",
      "C3 Bridge can measure reads itself: SERVER is the mean time of a read without the"
          + " network.",
      "",
      "CSV: seconds since the start, client, access, name, access_ms (empty if it failed),"
          + " failure. JSON: one object per access, times in ms.",
      "",
      "Examples:",
      "  jopenshowvar bench --host 172.31.1.147 --plot times.png",
      "  jopenshowvar bench '$OV_PRO' '$AXIS_ACT' --count 50000 --out times.csv --mock",
      "  jopenshowvar bench --clients 5 --for 30s --mock --latency krc4",
      "  jopenshowvar bench --write MYINT --write MYPOS --mock"
    })
public final class BenchCommand extends ControllerCommand {
  /** One variable of each type; every controller has them. */
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

  /** The maximum time of the server's own measurement of a variable. */
  private static final Duration SERVER_TIME = Duration.ofMillis(500);

  @Parameters(
      arity = "0..*",
      paramLabel = "NAME",
      description =
          "The variables to read. Default without --write: one system variable of each type.")
  private List<String> names = new ArrayList<>();

  @Option(
      names = "--write",
      paramLabel = "NAME",
      description = "Read this variable and write its value back. Can be repeated.")
  private List<String> written = new ArrayList<>();

  @Option(
      names = "--clients",
      paramLabel = "NUMBER",
      description = "Number of clients at the same time, each with its own connection. Default: 1.")
  private int clients = 1;

  @Option(
      names = "--count",
      paramLabel = "NUMBER",
      description = "Number of measured accesses of each client to each variable. Default: 1000.")
  private @Nullable Long count;

  @Option(
      names = "--for",
      paramLabel = "TIME",
      description = "Duration of the measurement, instead of --count.")
  private @Nullable Duration length;

  @Option(
      names = "--warm-up",
      paramLabel = "NUMBER",
      description = "Number of accesses before the measurement. Default: 100.")
  private int warmUp = 100;

  @Option(
      names = "--latency",
      paramLabel = "LATENCY",
      description = "Latency of the simulated controller, see 'mock --help'.")
  private @Nullable String latency;

  @Option(names = "--histogram", description = "Also print a histogram for each access.")
  private boolean histogram;

  @Option(
      names = {"-o", "--out"},
      paramLabel = "FILE.csv",
      description = "Write each access to a file.")
  private @Nullable Path out;

  @Option(
      names = "--plot",
      paramLabel = "FILE",
      description = "Draw the histograms to this" + " file, .png or .svg.")
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
      String limit = max == Long.MAX_VALUE ? min + " or more" : min + " to " + max;
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
    if (plot != null) {
      pictureOptions.checkSize(this, BenchReport.largestChart(accesses));
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
      // the measurements are always written
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

  /**
   * Returns the mean time of a read on the server itself, by the name of the variable. A failure is
   * printed, and the measurement of this program goes on without that time.
   */
  private Map<String, Double> serverMillis(CrossComClient client, List<BenchAccess> accesses)
      throws IOException {
    Map<String, Double> millis = new LinkedHashMap<>();
    for (BenchAccess access : accesses) {
      try {
        if (!access.write() && client.getServer().knows(MessageType.BENCHMARK)) {
          millis.put(access.name(), serverMillis(client, access.name()));
        }
      } catch (CrossComException e) {
        console().failure(e, isVerbose());
        if (ExitCode.of(e) != ExitCode.REFUSED) {
          return millis; // each of the others would wait as long
        }
      }
    }
    return millis;
  }

  private static double serverMillis(CrossComClient client, String name) throws IOException {
    // the server answers after the last read, which must not take too long
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
