package no.hials.crosscom.bench;

import java.io.IOException;
import java.io.PrintStream;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicLong;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.bench.CheckedVariable.Kind;
import no.hials.crosscom.bench.Findings.Defect;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;

/**
 * Changes exchanges on their way between client and server. Whatever is changed, the call ends with
 * the right value or an exception, as far as the bytes show it ({@link Mutation} says what is
 * expected of each), and the next call on the same client is right.
 */
public final class MutationRun {
  private static final int THREADS = 8;
  private static final int TRIES = 20;
  private static final long TIMEOUT_MILLIS = 100;
  private static final long LATE_NANOS = 150_000_000;

  private final PrintStream out;
  private final long exchanges;
  private final Map<Mutation, long[]> tally = new EnumMap<>(Mutation.class);

  MutationRun(PrintStream out, long exchanges) {
    this.out = out;
    this.exchanges = exchanges;
  }

  /**
   * Runs it against both servers, and exits with 1 if anything is wrong.
   *
   * @param args the number of exchanges to change for each server (20,000)
   * @throws IOException if a server or a proxy cannot be started
   */
  public static void main(String[] args) throws IOException {
    long exchanges = args.length > 0 ? Long.parseLong(args[0]) : 20_000;
    boolean clean = new MutationRun(System.out, exchanges).run(ServerType.KUKAVARPROXY);
    clean &= new MutationRun(System.out, exchanges).run(ServerType.C3_BRIDGE);
    System.exit(clean ? 0 : 1);
  }

  /** Runs it against one server; returns whether all was right. */
  boolean run(ServerType server) throws IOException {
    Trial trial = new Trial(out, server);
    AtomicLong left = new AtomicLong(exchanges);
    long start = System.nanoTime();
    try (trial) {
      trial.run(THREADS, request -> Fault.none(), worker -> work(trial, worker, left));
    }
    out.printf(
        Locale.ROOT,
        "%s: %,d exchanges changed, %.0f s%n",
        server,
        exchanges,
        (System.nanoTime() - start) / 1e9);
    out.printf("  %-22s %-15s %9s %9s%n", "change", "expected", "value", "exception");
    synchronized (tally) {
      tally.forEach(
          (mutation, counts) ->
              out.printf(
                  Locale.ROOT,
                  "  %-22s %-15s %,9d %,9d%n",
                  mutation,
                  mutation.effect(),
                  counts[1],
                  counts[0]));
    }
    trial.findings().print();
    return trial.findings().isClean();
  }

  private void work(Trial trial, Trial.Worker worker, AtomicLong left) throws IOException {
    boolean c3 = trial.robot().config().server() == ServerType.C3_BRIDGE;
    CheckedVariable[] all = worker.variables().toArray(CheckedVariable[]::new);
    SplittableRandom random = new SplittableRandom(worker.getName().hashCode());
    Mutation[] mutations = Mutation.values();
    try (MutatingProxy proxy = new MutatingProxy(trial.robot(), LATE_NANOS);
        CrossComClient client = worker.connect(proxy.port(), 30 * TIMEOUT_MILLIS)) {
      if (c3) {
        client.getServer(); // detects the server before anything is changed
      }
      client.setSoTimeout((int) TIMEOUT_MILLIS);
      while (left.get() > 0) {
        boolean write = random.nextBoolean();
        int choice = random.nextInt(c3 ? all.length + 1 : all.length);
        CheckedVariable[] chosen = choice == all.length ? all : new CheckedVariable[] {all[choice]};
        MessageType type = type(write, chosen);
        Mutation mutation = mutations[random.nextInt(mutations.length)];
        proxy.change(mutation, type, random.nextLong());
        boolean ok = worker.access(client, write, mutation.effect(), chosen);
        if (proxy.stop()) {
          left.decrementAndGet();
          count(mutation, ok);
          if (ok && !mutation.effect().allowsSuccess(write)) {
            trial.findings().add(Defect.WRONG_VALUE, "success in spite of " + mutation);
          }
        }
        check(trial.findings(), worker, client, chosen);
      }
    }
  }

  /** Reads until it succeeds; bytes of the exchange before can still come and break one. */
  private static void check(
      Findings findings, Trial.Worker worker, CrossComClient client, CheckedVariable... chosen) {
    for (int i = 0; i < TRIES; i++) {
      if (worker.access(client, false, Effect.RIGHT_OR_FAILS, chosen)) {
        return;
      }
    }
    findings.add(Defect.UNUSABLE, worker.getName());
  }

  private static MessageType type(boolean write, CheckedVariable... chosen) {
    if (chosen.length > 1) {
      return write ? MessageType.WRITE_MULTIPLE : MessageType.READ_MULTIPLE;
    }
    if (chosen[0].kind() == Kind.WIDE_TEXT) {
      return write ? MessageType.WRITE_UTF16 : MessageType.READ_UTF16;
    }
    return write ? MessageType.WRITE : MessageType.READ;
  }

  private void count(Mutation mutation, boolean ok) {
    synchronized (tally) {
      tally.computeIfAbsent(mutation, m -> new long[2])[ok ? 1 : 0]++;
    }
  }
}
