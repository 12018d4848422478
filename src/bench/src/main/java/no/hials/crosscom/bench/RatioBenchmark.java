package no.hials.crosscom.bench;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.VariableResult;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;

/**
 * Compares the client with a bare socket that sends the same bytes to the same server. The two take
 * turns, so that other load on the machine affects both.
 *
 * <p>A block is a number of consecutive exchanges of one of them; a round is four blocks: one,
 * other, other, one. Each trial has new connections, since the speed of connections differs. The
 * report has the median time of all blocks, per exchange, and the ratio of the medians.
 */
public final class RatioBenchmark {
  private static final int BLOCK = 25;
  private static final int SEVERAL = 10;
  private static final int WARM_UP_ROUNDS = 600;

  private final PrintStream out;
  private final int trials;
  private final int rounds;

  RatioBenchmark(PrintStream out, int trials, int rounds) {
    this.out = out;
    this.trials = trials;
    this.rounds = rounds;
  }

  /**
   * Runs the comparison. To run both sides on one CPU: {@code taskset -c 0 java ...}.
   *
   * @param args the number of trials (10) and of rounds in each trial (1000)
   * @throws IOException if an exchange fails
   */
  public static void main(String[] args) throws IOException {
    int trials = args.length > 0 ? Integer.parseInt(args[0]) : 10;
    int rounds = args.length > 1 ? Integer.parseInt(args[1]) : 1000;
    new RatioBenchmark(System.out, trials, rounds).run();
  }

  /**
   * The result of a comparison, in ns per exchange.
   *
   * @param one the median of the measured side
   * @param other the median of the bare socket
   * @param minimum the smallest ratio of a trial
   * @param maximum the largest ratio of a trial
   */
  record Result(double one, double other, double minimum, double maximum) {
    double ratio() {
      return one / other;
    }
  }

  void run() throws IOException {
    out.printf("CPUs for this process: %d%n", Runtime.getRuntime().availableProcessors());
    out.printf(
        "%-14s %10s %10s %7s %15s %13s %13s%n",
        "operation",
        "client us",
        "socket us",
        "ratio",
        "of trials",
        "client bytes",
        "socket bytes");
    for (Operation operation : Operation.values()) {
      measure(operation.name(), operation, false);
    }
    // the error of the method: two equal sides
    measure("socket twice", Operation.READ_INT, true);
    measureSeveral();
  }

  /** Compares one read of several variables with a read of each variable, on C3 Bridge. */
  private void measureSeveral() throws IOException {
    List<KRLInt> variables =
        IntStream.rangeClosed(1, SEVERAL).mapToObj(i -> new KRLInt("MYINTS[" + i + "]")).toList();
    List<double[]> ones = new ArrayList<>();
    List<double[]> others = new ArrayList<>();
    try (MockServer robot = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE))) {
      for (int trial = 0; trial < trials; trial++) {
        try (CrossComClient client = new CrossComClient(robot.host(), robot.port());
            CrossComClient other = new CrossComClient(robot.host(), robot.port())) {
          Exchange together =
              () -> {
                for (VariableResult result : client.readVariables(variables)) {
                  result.orThrow();
                }
                return SEVERAL;
              };
          Exchange singly =
              () -> {
                for (KRLInt variable : variables) {
                  other.readVariable(variable);
                }
                return SEVERAL;
              };
          compare(trial, together, singly, ones, others);
        }
      }
    }
    Result result = evaluate(ones, others);
    out.printf(
        Locale.ROOT,
        "C3 Bridge, %d INT: together %.3f us, singly %.3f us, ratio %.3f (%.3f-%.3f)%n",
        SEVERAL,
        result.one() / 1000,
        result.other() / 1000,
        result.ratio(),
        result.minimum(),
        result.maximum());
  }

  private void measure(String title, Operation operation, boolean control) throws IOException {
    List<double[]> ones = new ArrayList<>();
    List<double[]> others = new ArrayList<>();
    double oneBytes = Double.NaN;
    double otherBytes = Double.NaN;
    try (BareServer server = new BareServer(operation)) {
      for (int trial = 0; trial < trials; trial++) {
        try (CrossComClient client = new CrossComClient("127.0.0.1", server.port());
            BareClient first = new BareClient(server.port(), operation);
            BareClient bare = new BareClient(server.port(), operation)) {
          Exchange one = control ? first : operation.through(client);
          compare(trial, one, bare, ones, others);
          oneBytes = allocated(one, BLOCK * rounds);
          otherBytes = allocated(bare, BLOCK * rounds);
        }
      }
    }
    Result result = evaluate(ones, others);
    out.printf(
        Locale.ROOT,
        "%-14s %10.3f %10.3f %7.3f %7.3f-%7.3f %13.1f %13.1f%n",
        title,
        result.one() / 1000,
        result.other() / 1000,
        result.ratio(),
        result.minimum(),
        result.maximum(),
        oneBytes,
        otherBytes);
  }

  /** Adds the times of one trial, after a warm-up. */
  private void compare(
      int trial, Exchange one, Exchange other, List<double[]> ones, List<double[]> others)
      throws IOException {
    int warmUp = Math.min(rounds, trial == 0 ? WARM_UP_ROUNDS : WARM_UP_ROUNDS / 10);
    compare(one, other, new double[2 * warmUp], new double[2 * warmUp]);
    double[] oneTimes = new double[2 * rounds];
    double[] otherTimes = new double[2 * rounds];
    compare(one, other, oneTimes, otherTimes);
    ones.add(oneTimes);
    others.add(otherTimes);
  }

  private static void compare(Exchange one, Exchange other, double[] oneTimes, double[] otherTimes)
      throws IOException {
    for (int i = 0; i < oneTimes.length; i += 2) {
      oneTimes[i] = block(one);
      otherTimes[i] = block(other);
      otherTimes[i + 1] = block(other);
      oneTimes[i + 1] = block(one);
    }
  }

  /** Returns the time of an exchange in ns. */
  private static double block(Exchange exchange) throws IOException {
    // not timed, to refill the caches after the other side
    exchange.run();
    long start = System.nanoTime();
    for (int i = 0; i < BLOCK; i++) {
      exchange.run();
    }
    return (System.nanoTime() - start) / (double) BLOCK;
  }

  /** Returns the bytes of heap that this thread allocates per exchange. */
  static double allocated(Exchange exchange, int count) throws IOException {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long before = threads.getCurrentThreadAllocatedBytes();
    for (int i = 0; i < count; i++) {
      exchange.run();
    }
    return (threads.getCurrentThreadAllocatedBytes() - before) / (double) count;
  }

  static Result evaluate(List<double[]> ones, List<double[]> others) {
    double minimum = Double.POSITIVE_INFINITY;
    double maximum = 0;
    for (int i = 0; i < ones.size(); i++) {
      double ratio = median(ones.get(i)) / median(others.get(i));
      minimum = Math.min(minimum, ratio);
      maximum = Math.max(maximum, ratio);
    }
    return new Result(median(all(ones)), median(all(others)), minimum, maximum);
  }

  private static double[] all(List<double[]> trials) {
    return trials.stream().flatMapToDouble(Arrays::stream).toArray();
  }

  private static double median(double[] times) {
    double[] sorted = times.clone();
    Arrays.sort(sorted);
    int middle = sorted.length / 2;
    return sorted.length % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
  }
}
