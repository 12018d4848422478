package no.hials.crosscom.bench;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Function;
import java.util.stream.Stream;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComConnectException;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.VariableResult;
import no.hials.crosscom.bench.CheckedVariable.Kind;
import no.hials.crosscom.bench.Findings.Defect;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.variable.Assignment;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteMultipleRequest;

/**
 * Threads that use one server, each with its own client and variables. Every call is checked; a
 * call that does not return, and threads and sockets that are left, are found.
 */
final class Trial implements AutoCloseable {
  private static final long HANG_NANOS = 30_000_000_000L;
  private static final long SETTLE_NANOS = 10_000_000_000L;
  private static final long LOOK_MILLIS = 50;
  private static final Path OPEN_FILES = Path.of("/proc/self/fd");

  private final Findings findings;
  private final Set<Thread> threadsBefore;
  private final Set<String> socketsBefore;
  private final MockServer robot;
  private final List<Worker> workers = new ArrayList<>();

  /** The work of a thread. */
  @FunctionalInterface
  interface Work {
    void run(Worker worker) throws IOException;
  }

  Trial(PrintStream out, ServerType server) throws IOException {
    warmUp();
    threadsBefore = threads();
    socketsBefore = sockets();
    findings = new Findings(out);
    robot = MockServer.start(cfg -> cfg.server(server).maxClients(0).recordedRequests(1000));
  }

  /** Opens what the JVM opens once, with the first socket. */
  private static void warmUp() throws IOException {
    try (MockServer robot = MockServer.start();
        CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
      client.readText("PING");
    }
  }

  MockServer robot() {
    return robot;
  }

  Findings findings() {
    return findings;
  }

  /** One thread, its variables, and the client that it uses now. */
  final class Worker extends Thread {
    private final List<CheckedVariable> variables = new ArrayList<>();
    private final Work work;

    /** When the call under way began, by {@link System#nanoTime}; 0 without a call. */
    private volatile long since;

    private Worker(int number, Work work) {
      super("trial-" + number);
      setDaemon(true);
      this.work = work;
      boolean c3 = robot.config().server() == ServerType.C3_BRIDGE;
      for (Kind kind : Kind.values()) {
        if (kind != Kind.WIDE_TEXT || c3) {
          String name = "TRIAL_" + kind + "_" + number;
          variables.add(new CheckedVariable(kind, name, robot.variables()));
        }
      }
    }

    List<CheckedVariable> variables() {
      return variables;
    }

    @Override
    public void run() {
      try {
        work.run(this);
      } catch (IOException | RuntimeException | AssertionError e) {
        findings.add(Defect.FOREIGN_EXCEPTION, getName() + ": " + e);
      } finally {
        since = 0;
      }
    }

    /**
     * Reads or writes variables, one by one or together, and checks the result.
     *
     * @param effect what the answer may lead to
     * @return whether all of it succeeded
     */
    boolean access(CrossComClient client, boolean write, Effect effect, CheckedVariable... chosen) {
      if (write) {
        for (CheckedVariable variable : chosen) {
          variable.setNext();
        }
      }
      boolean ok = true;
      since = System.nanoTime();
      try {
        for (VariableResult result : results(client, write, chosen)) {
          CheckedVariable variable = of(result, chosen);
          CrossComException failure = result.failure();
          if (failure == null) {
            check(variable, write, effect);
          } else {
            ok = false;
            failed(failure, write && (effect.lies() || failure.isOutcomeUnknown()), variable);
          }
        }
      } catch (RuntimeException e) {
        ok = false;
        findings.add(Defect.FOREIGN_EXCEPTION, e.toString());
        Arrays.stream(chosen).forEach(CheckedVariable::unknown);
      } finally {
        since = 0;
      }
      return ok;
    }

    private void check(CheckedVariable variable, boolean write, Effect effect) {
      // a value that was changed on its way shows nothing
      boolean right = write ? variable.written() : effect == Effect.ANY_VALUE || variable.read();
      if (!right && effect != Effect.ANY_VALUE) {
        findings.add(Defect.WRONG_VALUE, (write ? "echo of " : "read ") + variable);
      }
    }

    private List<VariableResult> results(
        CrossComClient client, boolean write, CheckedVariable... chosen) {
      if (chosen.length > 1) {
        var several = Arrays.stream(chosen).map(CheckedVariable::variable).toList();
        return write ? client.writeVariables(several) : client.readVariables(several);
      }
      var variable = chosen[0].variable();
      try {
        if (write) {
          client.writeVariable(variable);
        } else {
          client.readVariable(variable);
        }
        return List.of(new VariableResult(variable, null));
      } catch (CrossComException e) {
        return List.of(new VariableResult(variable, e));
      } catch (IOException e) {
        throw new IllegalStateException("not the client's own exception", e);
      }
    }

    private CheckedVariable of(VariableResult result, CheckedVariable... chosen) {
      return Arrays.stream(chosen)
          .filter(variable -> variable.variable() == result.variable())
          .findFirst()
          .orElseThrow();
    }

    private void failed(CrossComException e, boolean unknown, CheckedVariable variable) {
      findings.count("  " + e.getClass().getSimpleName(), 1);
      if (unknown) {
        variable.unknown();
      }
      if (e instanceof CrossComConnectException) {
        LockSupport.parkNanos(1_000_000); // the client waits before it connects again
      }
    }

    CrossComClient connect(int port, long timeoutMillis) throws CrossComException {
      since = System.nanoTime();
      try {
        return new CrossComClient(
            ClientConfig.create(
                robot.host(),
                cfg ->
                    cfg.port(port)
                        .requestTimeout(Duration.ofMillis(timeoutMillis))
                        .reconnectBackoff(Duration.ofMillis(1), Duration.ofMillis(20))));
      } finally {
        since = 0;
      }
    }

    private boolean hangs() {
      long start = since;
      return start != 0 && System.nanoTime() - start > HANG_NANOS;
    }
  }

  /**
   * Runs the threads until they have ended or one hangs.
   *
   * @param count their number
   * @param faults chooses the fault of each request
   * @param work the work of each
   */
  void run(int count, Function<RecordedRequest, Fault> faults, Work work) throws IOException {
    Map<String, CheckedVariable> byName = new ConcurrentHashMap<>();
    for (int i = 1; i <= count; i++) {
      Worker worker = new Worker(i, work);
      workers.add(worker);
      worker.variables.forEach(variable -> byName.put(variable.variable().getName(), variable));
    }
    robot.faults(
        request -> {
          observe(request, byName);
          return Optional.of(faults.apply(request));
        });
    workers.forEach(Thread::start);
    try {
      for (Worker worker : workers) {
        while (worker.isAlive() && workers.stream().noneMatch(Worker::hangs)) {
          worker.join(LOOK_MILLIS);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
    for (Worker worker : workers) {
      if (worker.hangs()) {
        findings.add(Defect.HANG, worker.getName() + Arrays.toString(worker.getStackTrace()));
      }
    }
  }

  private void observe(RecordedRequest request, Map<String, CheckedVariable> byName) {
    if (request.request() instanceof WriteMultipleRequest several) {
      for (Assignment assignment : several.assignments()) {
        observe(assignment.name(), assignment.value(), byName);
      }
    } else if (request.isWrite()) {
      observe(request.name(), String.valueOf(request.value()), byName);
    }
  }

  private void observe(String name, String value, Map<String, CheckedVariable> byName) {
    CheckedVariable variable = byName.get(name);
    if (variable == null || !variable.received(value)) {
      findings.add(Defect.REPEATED_WRITE, name + " = " + value);
    }
  }

  /** Closes the server, and looks for threads and sockets that are left. */
  @Override
  public void close() throws IOException {
    findings.count("requests that the server received", robot.requestCount());
    robot.close();
    long end = System.nanoTime() + SETTLE_NANOS;
    Set<Thread> left = Set.of();
    Set<String> open = Set.of();
    do {
      LockSupport.parkNanos(LOOK_MILLIS * 1_000_000);
      left = threads();
      left.removeAll(threadsBefore);
      open = sockets();
      open.removeAll(socketsBefore);
    } while (!(left.isEmpty() && open.isEmpty()) && System.nanoTime() < end);
    left.forEach(thread -> findings.add(Defect.THREAD, thread.getName()));
    open.forEach(socket -> findings.add(Defect.SOCKET, socket));
  }

  private static Set<Thread> threads() {
    return new HashSet<>(Thread.getAllStackTraces().keySet());
  }

  /** Returns the sockets of this process; none where there is no {@code /proc}. */
  private static Set<String> sockets() throws IOException {
    Set<String> sockets = new HashSet<>();
    if (Files.exists(OPEN_FILES)) {
      try (Stream<Path> files = Files.list(OPEN_FILES)) {
        for (Path file : (Iterable<Path>) files::iterator) {
          try {
            String target = Files.readSymbolicLink(file).toString();
            if (target.startsWith("socket:")) {
              sockets.add(target);
            }
          } catch (NoSuchFileException e) {
            // closed meanwhile, as the file of this list
          }
        }
      }
    }
    return sockets;
  }
}
