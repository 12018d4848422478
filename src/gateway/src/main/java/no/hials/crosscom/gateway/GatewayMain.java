package no.hials.crosscom.gateway;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.cell.DaemonThreadFactory;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.cell.feed.Plant;
import no.hials.crosscom.cell.feed.PollPlan;
import no.hials.crosscom.gateway.internal.mqtt.MqttKind;
import no.hials.crosscom.gateway.internal.opcua.OpcUaKind;
import no.hials.crosscom.gateway.internal.prometheus.PrometheusKind;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Runs the gateway: {@code jopenshowvar gateway}. */
@Command(
    name = "jopenshowvar gateway",
    mixinStandardHelpOptions = true,
    sortOptions = false,
    description = {
      "Passes the values of robots on to MQTT, OPC UA and Prometheus until Ctrl-C.",
      "The plan of accesses is printed first; a plan that would load a controller too much is"
          + " refused."
    },
    footer = {
      "",
      "docs/reference/gateway.md describes the file. A changed file is loaded without a restart.",
      "",
      "Examples:",
      "  jopenshowvar gateway --config plant.toml",
      "  jopenshowvar gateway --mock 3 --mqtt tcp://127.0.0.1:1883 --prometheus 127.0.0.1:9464"
    })
public final class GatewayMain implements Callable<Integer> {
  private static final Logger LOG = LoggerFactory.getLogger(GatewayMain.class);
  private static final List<OutputKind<?>> KINDS =
      List.of(new PrometheusKind(), new MqttKind(), new OpcUaKind());
  private static final long CHANGE_CHECK_SECONDS = 1;

  /** A broker that is silent costs some seconds; then unconfirmed messages are stored. */
  private static final long MAX_SECONDS_TO_END = 30;

  private static final int MAX_MOCKS = 1000;
  private static final int WRONG_USAGE = 2;
  private static final int FAILED = 3;

  @Spec private CommandLine.Model.@Nullable CommandSpec spec;

  @Option(
      names = "--config",
      paramLabel = "FILE",
      description = "The configuration: robots, variables, outputs.")
  private @Nullable Path file;

  @Option(
      names = "--mock",
      paramLabel = "N",
      description = "Simulate N more robots, named mock1, mock2, ..., which move.")
  private int mocks;

  @Option(
      names = "--mqtt",
      paramLabel = "URL",
      description = "Publish to this broker, such as tcp://127.0.0.1:1883; as url in [mqtt].")
  private @Nullable String mqtt;

  @Option(
      names = "--prometheus",
      paramLabel = "ADDRESS",
      description =
          "Listen for Prometheus on this address, such as 127.0.0.1:9464; as address in"
              + " [prometheus].")
  private @Nullable String prometheus;

  @Option(
      names = "--opcua",
      paramLabel = "ADDRESS",
      description =
          "Listen for OPC UA clients on this address, such as 127.0.0.1:4840; as address in"
              + " [opcua].")
  private @Nullable String opcua;

  @Option(
      names = "--data",
      paramLabel = "FOLDER",
      description =
          "Folder for the audit log, stored messages and certificates. Default: the folder"
              + " gateway-data next to the configuration, or in the current folder.")
  private @Nullable Path folder;

  @Option(names = "--dry-run", description = "Print the plan, and end.")
  private boolean dryRun;

  private GatewayMain() {}

  /**
   * Runs the gateway, and exits the process.
   *
   * @param args the arguments
   */
  public static void main(String... args) {
    PrintWriter out = new PrintWriter(System.out, true, StandardCharsets.UTF_8);
    PrintWriter err = new PrintWriter(System.err, true, StandardCharsets.UTF_8);
    System.exit(run(out, err, args));
  }

  /** Runs the gateway until it is stopped, and returns the exit code. */
  static int run(PrintWriter out, PrintWriter err, String... args) {
    CommandLine line = new CommandLine(new GatewayMain()).setOut(out).setErr(err);
    line.setExecutionExceptionHandler(
        (failure, command, result) -> {
          if (!(failure instanceof IOException)) {
            throw failure;
          }
          command.getErr().println("jopenshowvar: " + failure.getMessage());
          command.getErr().flush();
          return failure instanceof FileException ? WRONG_USAGE : FAILED;
        });
    line.setParameterExceptionHandler(
        (failure, arguments) -> {
          failure.getCommandLine().getErr().println("jopenshowvar: " + failure.getMessage());
          failure.getCommandLine().getErr().flush();
          return WRONG_USAGE;
        });
    return line.execute(args);
  }

  @Override
  public Integer call() throws IOException, InterruptedException {
    if (file == null && mocks == 0) {
      throw wrongUsage("there is no robot: use --config FILE or --mock N");
    }
    if (mocks < 0 || mocks > MAX_MOCKS) {
      throw wrongUsage("--mock must be 1 to " + MAX_MOCKS + ", is " + mocks);
    }
    // a pipe can be read only once
    boolean canChange = file != null && Files.isRegularFile(file);
    try (SimulatedRobots simulated = new SimulatedRobots(mocks)) {
      GatewayConfig config = read(simulated.robots());
      print(config.plant());
      if (dryRun) {
        return 0;
      }
      if (config.outputs().isEmpty()) {
        throw wrongUsage("there is no output: add a table [mqtt], [opcua] or [prometheus]");
      }
      CountDownLatch end = new CountDownLatch(1);
      CountDownLatch ended = new CountDownLatch(1);
      Runtime.getRuntime().addShutdownHook(new Thread(() -> stop(end, ended), "stop"));
      try (Gateway gateway = Gateway.start(config, KINDS, simulated::open)) {
        if (canChange) {
          follow(gateway, config, simulated.robots());
        }
        end.await();
      } finally {
        ended.countDown();
      }
      return 0;
    }
  }

  /** Called when the process is stopped; waits for the gateway to close. */
  private static void stop(CountDownLatch end, CountDownLatch ended) {
    end.countDown();
    try {
      if (!ended.await(MAX_SECONDS_TO_END, TimeUnit.SECONDS)) {
        LOG.error(
            "the gateway did not end within {} s: messages that are not stored are lost",
            MAX_SECONDS_TO_END);
      }
    } catch (InterruptedException e) {
      // the process ends anyway
    }
  }

  /** Begins to apply changes of the file, on a thread that the end does not wait for. */
  private void follow(Gateway gateway, GatewayConfig first, Map<String, Robot> mocked) {
    ConfigFollower follower = new ConfigFollower(gateway, first, () -> readAgain(mocked));
    Runnable check =
        () -> {
          if (follower.check()) {
            print(gateway.plant());
          }
        };
    ScheduledFuture<?> unused =
        Executors.newSingleThreadScheduledExecutor(DaemonThreadFactory.named("config"))
            .scheduleWithFixedDelay(
                Lasting.task(check), CHANGE_CHECK_SECONDS, CHANGE_CHECK_SECONDS, TimeUnit.SECONDS);
  }

  private GatewayConfig readAgain(Map<String, Robot> mocked) throws FileException {
    // opening anything else could block without end
    if (file != null && Files.exists(file) && !Files.isRegularFile(file)) {
      throw new FileException("cannot read " + file + ": it is not a regular file");
    }
    return read(mocked);
  }

  private void print(Plant plant) {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    for (PollPlan plan : plant.plans()) {
      out.println(plan.text());
    }
    out.flush();
  }

  /** Reads the file, and adds the tables that the options stand for. */
  private GatewayConfig read(Map<String, Robot> more) throws FileException {
    Path place = file == null ? Path.of("options") : file;
    String text = file == null ? "" : TomlTable.textOf(file);
    Map<String, String> options = options();
    if (!options.isEmpty()) {
      TomlTable root = TomlTable.parse(place, text);
      for (String table : options.keySet()) {
        if (root.has(table)) {
          throw new FileException(
              root.place(table)
                  + ": --"
                  + table
                  + " and the table "
                  + table
                  + " exclude each other");
        }
      }
    }
    StringBuilder all = new StringBuilder(text).append('\n');
    options.forEach((table, setting) -> all.append('[' + table + "]\n").append(setting));
    Path data = folder;
    if (data == null) {
      Path parent = file == null ? null : file.toAbsolutePath().getParent();
      data = parent == null ? Path.of("gateway-data") : parent.resolve("gateway-data");
    }
    return GatewayConfig.read(TomlTable.parse(place, all.toString()), data, more, KINDS);
  }

  /** Returns the settings of the options by the names of their tables. */
  private Map<String, String> options() {
    Map<String, String> tables = new LinkedHashMap<>();
    put(tables, "mqtt", "url", mqtt);
    put(tables, "prometheus", "address", prometheus);
    put(tables, "opcua", "address", opcua);
    return tables;
  }

  private static void put(
      Map<String, String> tables, String table, String key, @Nullable String value) {
    if (value != null) {
      String quoted = value.replace("\\", "\\\\").replace("\"", "\\\"");
      tables.put(table, key + " = \"" + quoted + "\"\n");
    }
  }

  private ParameterException wrongUsage(String message) {
    return new ParameterException(Objects.requireNonNull(spec).commandLine(), message);
  }
}
