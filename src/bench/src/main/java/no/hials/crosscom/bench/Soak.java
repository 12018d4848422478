package no.hials.crosscom.bench;

import java.io.IOException;
import java.io.PrintStream;
import java.time.Duration;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import java.util.function.IntFunction;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;

/**
 * Many clients that read and write under faults of the server: each value is checked, and no write
 * may come twice.
 */
public final class Soak {
  private static final long TIMEOUT_MILLIS = 300;
  private static final int CALLS_PER_CLIENT = 500;
  private static final int GARBAGE = 40;

  /** The faults that a client can notice; the number is random. */
  private static final List<IntFunction<Fault>> FAULTS =
      List.of(
          n -> Fault.raw("DE AD BE EF"),
          n -> Fault.answer("", n % 2 == 0 ? Tail.FAILURE : Tail.FAILURE_ZERO),
          n -> Fault.emptyAnswer(),
          n -> Fault.drop(),
          n -> Fault.dropAnswer(),
          n -> Fault.closeBefore(),
          n -> Fault.resetBefore(),
          n -> Fault.closeDuring(n % 20),
          n -> Fault.closeAfter(),
          n -> Fault.delay(Duration.ofMillis(n % 50)),
          n -> Fault.delay(Duration.ofMillis(TIMEOUT_MILLIS + n % 200)),
          n -> Fault.split(1 + n % 12, 1 + n % 5),
          n -> Fault.oneByteAtATime(),
          n -> Fault.oneByteAtATime(Duration.ofMillis(1)),
          n -> Fault.answerTwice(),
          n -> Fault.glueToNext(),
          n -> Fault.wrongId(),
          n -> Fault.wrongFunction(64 + n % 192),
          n -> Fault.wrongLength(n % 2 == 0 ? 1 + n % 9 : -1 - n % 9),
          n -> Fault.truncate(n % 20),
          n -> Fault.garbage(n, 1 + n % GARBAGE));

  private final PrintStream out;
  private final long requests;
  private final int threads;
  private final double faultPercent;

  Soak(PrintStream out, long requests, int threads, double faultPercent) {
    this.out = out;
    this.requests = requests;
    this.threads = threads;
    this.faultPercent = faultPercent;
  }

  /**
   * Runs the soak against both servers, and exits with 1 if anything is wrong.
   *
   * @param args the number of calls for each server (1,000,000), of threads (50), and the
   *     percentage of requests with a fault (2)
   * @throws IOException if a server cannot be started
   */
  public static void main(String[] args) throws IOException {
    Soak soak =
        new Soak(
            System.out,
            args.length > 0 ? Long.parseLong(args[0]) : 1_000_000,
            args.length > 1 ? Integer.parseInt(args[1]) : 50,
            args.length > 2 ? Double.parseDouble(args[2]) : 2);
    boolean clean = soak.run(ServerType.KUKAVARPROXY);
    clean &= soak.run(ServerType.C3_BRIDGE);
    System.exit(clean ? 0 : 1);
  }

  /** Runs it against one server; returns whether all was right. */
  boolean run(ServerType server) throws IOException {
    Trial trial = new Trial(out, server);
    Findings findings = trial.findings();
    AtomicLong left = new AtomicLong(requests);
    long start = System.nanoTime();
    try (trial) {
      trial.run(threads, faults(findings), worker -> work(trial, worker, left));
    }
    out.printf(
        "%s: %,d calls by %d threads, %s %% faults, %.0f s%n",
        server, requests, threads, faultPercent, (System.nanoTime() - start) / 1e9);
    findings.print();
    return findings.isClean();
  }

  /** Chooses the fault of a request by its number, so that a run has the same faults again. */
  private Function<RecordedRequest, Fault> faults(Findings findings) {
    return request -> {
      SplittableRandom random = new SplittableRandom(request.number());
      if (random.nextDouble() * 100 >= faultPercent) {
        return Fault.none();
      }
      findings.count("faults", 1);
      return FAULTS.get(random.nextInt(FAULTS.size())).apply(random.nextInt(1 << 16));
    };
  }

  private static void work(Trial trial, Trial.Worker worker, AtomicLong left) throws IOException {
    MockServer robot = trial.robot();
    Findings findings = trial.findings();
    SplittableRandom random = new SplittableRandom(worker.getName().hashCode());
    CheckedVariable[] all = worker.variables().toArray(CheckedVariable[]::new);
    while (left.get() > 0) {
      findings.count("clients", 1);
      long failed = 0;
      try (CrossComClient client = worker.connect(robot.port(), TIMEOUT_MILLIS)) {
        for (int i = 0; i < CALLS_PER_CLIENT && left.getAndDecrement() > 0; i++) {
          int choice = random.nextInt(all.length + 1);
          CheckedVariable[] chosen =
              choice == all.length ? all : new CheckedVariable[] {all[choice]};
          failed +=
              worker.access(client, random.nextBoolean(), Effect.RIGHT_OR_FAILS, chosen) ? 0 : 1;
        }
      }
      findings.count("calls that failed", failed);
    }
  }
}
