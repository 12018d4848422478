package no.hials.crosscom.bench;

import java.io.Closeable;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import no.hials.crosscom.mock.MockServer;

/** Loads the mock server: requests per second, idle connections, and memory over many requests. */
public final class MockLoad {
  private static final int CONNECTIONS = 4;

  private final PrintStream out;

  MockLoad(PrintStream out) {
    this.out = out;
  }

  /**
   * Runs all measurements.
   *
   * @param args not used
   * @throws IOException if an exchange fails
   * @throws InterruptedException if the thread is interrupted
   */
  public static void main(String[] args) throws IOException, InterruptedException {
    MockLoad load = new MockLoad(System.out);
    load.idle(1000);
    load.throughput(5, 100_000);
    load.soak(2_000_000, 8);
  }

  /** Opens idle connections. */
  void idle(int connections) throws IOException {
    try (MockServer robot = MockServer.start(cfg -> cfg.maxClients(0).idleTimeout(Duration.ZERO))) {
      List<Closeable> open = new ArrayList<>();
      try {
        long before = residentKibibytes();
        int threadsBefore = threads();
        for (int i = 0; i < connections; i++) {
          BareClient client = new BareClient(robot.port(), Operation.READ_INT);
          open.add(client);
          client.run(); // by now the server has a thread for it that has used its stack
        }
        long grown = residentKibibytes() - before;
        out.printf(
            Locale.ROOT,
            "%d idle connections: %d more threads, %d KiB more resident, both ends, %.1f KiB each%n",
            robot.clientCount(),
            threads() - threadsBefore,
            grown,
            grown / (double) connections);
      } finally {
        for (Closeable client : open) {
          client.close();
        }
      }
    }
  }

  /** Sends requests over several connections at once, each at full speed. */
  void throughput(int repetitions, int requestsPerConnection) throws IOException {
    for (Operation operation : Operation.values()) {
      try (MockServer robot = start()) {
        StringBuilder rates = new StringBuilder();
        for (int i = 0; i < repetitions; i++) {
          long nanos = load(robot, operation, requestsPerConnection);
          rates.append(
              String.format(
                  Locale.ROOT, " %.0f", CONNECTIONS * requestsPerConnection / (nanos / 1e9)));
        }
        out.println(operation + ", requests/s over " + CONNECTIONS + " connections:" + rates);
      }
    }
  }

  /** Sends requests for a long time, and prints the memory at intervals. */
  void soak(int requests, int looks) throws IOException {
    try (MockServer robot = start()) {
      for (int i = 0; i < looks; i++) {
        for (Operation operation : Operation.values()) {
          load(robot, operation, requests / looks / Operation.values().length / CONNECTIONS);
        }
        System.gc();
        long used = ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
        out.printf(
            Locale.ROOT,
            "soak: %d requests, heap after GC %.2f MiB, resident %.1f MiB%n",
            robot.requestCount(),
            used / 1048576.0,
            residentKibibytes() / 1024.0);
      }
    }
  }

  private static MockServer start() throws IOException {
    MockServer robot = MockServer.start();
    Operation.declare(robot.variables());
    return robot;
  }

  /** Returns the time, ns. */
  private static long load(MockServer robot, Operation operation, int requestsPerConnection)
      throws IOException {
    List<Thread> threads = new ArrayList<>();
    List<Throwable> failures = new ArrayList<>();
    List<BareClient> clients = new ArrayList<>();
    for (int i = 0; i < CONNECTIONS; i++) {
      clients.add(new BareClient(robot.port(), operation));
    }
    long start = System.nanoTime();
    for (BareClient client : clients) {
      Thread thread =
          new Thread(
              () -> {
                try (client) {
                  for (int n = 0; n < requestsPerConnection; n++) {
                    client.run();
                  }
                } catch (IOException e) {
                  throw new UncheckedIOException(e);
                }
              },
              "load");
      thread.setUncaughtExceptionHandler(
          (failed, e) -> {
            synchronized (failures) {
              failures.add(e);
            }
          });
      thread.start();
      threads.add(thread);
    }
    for (Thread thread : threads) {
      join(thread);
    }
    long nanos = System.nanoTime() - start;
    synchronized (failures) {
      if (!failures.isEmpty()) {
        throw new IOException("a connection failed", failures.get(0));
      }
    }
    return nanos;
  }

  private static void join(Thread thread) throws IOException {
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
  }

  private static int threads() {
    return ManagementFactory.getThreadMXBean().getThreadCount();
  }

  /** Returns the resident memory of the process; 0 without {@code /proc}. */
  static long residentKibibytes() throws IOException {
    Path status = Path.of("/proc/self/status");
    if (!Files.exists(status)) {
      return 0;
    }
    try (Stream<String> lines = Files.lines(status)) {
      return lines
          .filter(line -> line.startsWith("VmRSS:"))
          .mapToLong(line -> Long.parseLong(line.replaceAll("\\D", "")))
          .findFirst()
          .orElse(0);
    }
  }
}
