package no.hials.crosscom.gateway;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.DaemonThreadFactory;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.feed.Plant;
import no.hials.crosscom.cell.feed.PollPlan;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.cell.feed.Writes;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reads the robots of a configuration and passes their values on to its outputs. {@link #apply}
 * changes the configuration without interrupting the robots and outputs that stay the same.
 */
public final class Gateway implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Gateway.class);
  private static final long AGE_CHECK_MILLIS = 250;

  private final List<OutputKind<?>> kinds;
  private final RobotConnection.Opener opener;
  private final Health health = new Health();
  private final Writes writes;
  private final Path folder;
  private final Map<String, RobotFeed> robots = new ConcurrentHashMap<>();
  private final Map<String, RunningOutput> outputs = new ConcurrentHashMap<>();
  private final ScheduledExecutorService timer =
      Executors.newSingleThreadScheduledExecutor(DaemonThreadFactory.named("gateway-timer"));
  private volatile Plant plant;
  private boolean closed;

  private Gateway(GatewayConfig config, List<OutputKind<?>> kinds, RobotConnection.Opener opener) {
    this.kinds = List.copyOf(kinds);
    this.opener = opener;
    this.plant = config.plant();
    this.folder = config.folder();
    this.writes = new Writes(new AuditLog(folder));
  }

  /**
   * Starts a gateway.
   *
   * @param kinds the available kinds of outputs
   * @param opener connects to robots
   * @throws IOException if an output cannot start
   */
  public static Gateway start(
      GatewayConfig config, List<OutputKind<?>> kinds, RobotConnection.Opener opener)
      throws IOException {
    Gateway gateway = new Gateway(config, kinds, opener);
    try {
      gateway.apply(config);
    } catch (IOException | RuntimeException | Error e) {
      gateway.close();
      throw e;
    }
    ScheduledFuture<?> unused =
        gateway.timer.scheduleAtFixedRate(
            Lasting.task(() -> gateway.robots.values().forEach(RobotFeed::checkAges)),
            AGE_CHECK_MILLIS,
            AGE_CHECK_MILLIS,
            TimeUnit.MILLISECONDS);
    return gateway;
  }

  /** An output with its settings. Its failures are logged, and affect nothing else. */
  private static final class RunningOutput {
    private final Object settings;
    private final Output output;
    private volatile boolean failing;
    private boolean ready;

    RunningOutput(Object settings, Output output) {
      this.settings = settings;
      this.output = output;
    }

    /** Called when the robots are added; only the first call has an effect. */
    void ready() throws IOException {
      if (!ready) {
        output.ready();
        ready = true;
      }
    }

    void call(Consumer<Output> call) {
      try {
        call.accept(output);
        failing = false;
      } catch (RuntimeException | Error e) {
        if (!failing) {
          LOG.warn("an output failed", e);
        }
        failing = true;
      }
    }
  }

  private final class Context implements GatewayContext {
    @Override
    public Plant plant() {
      return plant;
    }

    @Override
    public @Nullable RobotFeed robot(String name) {
      return robots.get(name);
    }

    @Override
    public Writes writes() {
      return writes;
    }

    @Override
    public Path folder() {
      return folder;
    }

    @Override
    public Health health() {
      return health;
    }
  }

  /**
   * Applies another configuration. Robots and outputs that it does not change are not interrupted.
   * Applying the same configuration again starts the outputs and robots that could not start
   * before. Has no effect on a closed gateway.
   *
   * @throws IOException if an output or a robot cannot start; the others are as configured
   */
  public synchronized void apply(GatewayConfig config) throws IOException {
    if (closed) {
      return;
    }
    checkThreads();
    plant = config.plant();
    Map<String, PollPlan> plans = new LinkedHashMap<>();
    plant.plans().forEach(plan -> plans.put(plan.robot().name(), plan));
    for (RobotFeed feed : List.copyOf(robots.values())) {
      if (!feed.plan().equals(plans.get(feed.name()))) {
        remove(feed);
      }
    }
    IOException failure = null;
    for (OutputKind<?> kind : kinds) {
      try {
        apply(kind, config.outputs().get(kind.table()));
      } catch (IOException | RuntimeException | Error e) {
        // as in a call of an output: it must not end the gateway
        failure = cannotStart("[" + kind.table() + "]", e);
      }
    }
    for (PollPlan plan : plans.values()) {
      if (!robots.containsKey(plan.robot().name())) {
        try {
          add(plan);
        } catch (IOException | OutOfMemoryError e) {
          failure = cannotStart(plan.robot().name(), e);
        }
      }
    }
    for (Map.Entry<String, RunningOutput> one : List.copyOf(outputs.entrySet())) {
      try {
        one.getValue().ready();
      } catch (IOException | RuntimeException | Error e) {
        outputs.remove(one.getKey());
        one.getValue().call(Output::close);
        failure = cannotStart("[" + one.getKey() + "]", e);
      }
    }
    if (failure != null) {
      throw failure;
    }
  }

  private static IOException cannotStart(String what, Throwable why) {
    return why instanceof IOException known
        ? known
        : new IOException(what + " cannot start: " + why, why);
  }

  /**
   * Throws an exception if the system starts no threads now: the parts of an output that are there
   * when it starts none of its own could not be ended.
   */
  private static void checkThreads() throws IOException {
    try {
      new Thread(() -> {}, "gateway-check").start();
    } catch (OutOfMemoryError e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  private <S> void apply(OutputKind<S> kind, @Nullable Object settings) throws IOException {
    RunningOutput running = outputs.get(kind.table());
    if (running != null && !running.settings.equals(settings)) {
      outputs.remove(kind.table());
      running.call(Output::close);
      running = null;
    }
    if (running == null && settings != null) {
      @SuppressWarnings("unchecked") // read by the same kind
      S own = (S) settings;
      RunningOutput started = new RunningOutput(own, kind.open(own, new Context()));
      robots.values().forEach(robot -> started.call(output -> output.added(robot)));
      outputs.put(kind.table(), started);
      robots.values().forEach(RobotFeed::repeat);
    }
  }

  private void add(PollPlan plan) throws IOException {
    RobotFeed feed = RobotFeed.open(plan, opener, this::passOn);
    robots.put(plan.robot().name(), feed);
    outputs.values().forEach(one -> one.call(output -> output.added(feed)));
    // if the robot is off, its first updates came before the outputs knew it
    feed.repeat();
    try {
      feed.start();
    } catch (IOException | OutOfMemoryError e) {
      remove(feed); // the next attempt opens it again
      throw e;
    }
  }

  private void passOn(RobotFeed robot, List<Update> updates) {
    outputs.values().forEach(one -> one.call(output -> output.updated(robot, updates)));
  }

  private void remove(RobotFeed feed) {
    robots.remove(feed.name());
    try {
      feed.close();
    } catch (IOException e) {
      LOG.warn("{}: {}", feed.name(), e.getMessage());
    }
    outputs.values().forEach(one -> one.call(output -> output.removed(feed)));
  }

  /** Returns the plant of the configuration. */
  public Plant plant() {
    return plant;
  }

  /** Returns the robots. */
  public List<RobotFeed> robots() {
    return List.copyOf(robots.values());
  }

  /** Returns the figures of the gateway itself. */
  public Health health() {
    return health;
  }

  /** Stops all readings and outputs. */
  @Override
  public synchronized void close() {
    closed = true;
    timer.shutdownNow();
    writes.end();
    outputs.values().forEach(one -> one.call(Output::endWrites));
    List.copyOf(robots.values()).forEach(this::remove);
    outputs.values().forEach(one -> one.call(Output::close));
    outputs.clear();
  }
}
