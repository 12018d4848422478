package no.hials.crosscom.lab.bench;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.cell.recording.OutputException;
import org.jspecify.annotations.Nullable;

/**
 * Measures how long accesses take. Each client has its own thread and sends an access as soon as
 * the previous one is answered (a closed loop). So a slow answer lowers the rate; it does not add
 * waiting time to later requests.
 */
public final class Bench implements Closeable {
  private static final long TICK_MILLIS = 50;

  /** A client gives up after this number of failures in succession. */
  private static final int MAX_FAILURES = 10;

  private final BenchPlan plan;
  private final List<Client> clients = new ArrayList<>();
  private final CountDownLatch warm;
  private final CountDownLatch go = new CountDownLatch(1);
  private final CountDownLatch done;
  private final AtomicReference<RuntimeException> broken = new AtomicReference<>();
  private volatile boolean stopped;
  private volatile long begin;
  private volatile long end = Long.MAX_VALUE;

  /**
   * The plan of a measurement.
   *
   * @param accesses the accesses in order; a write follows the read of the value that it writes
   *     back
   * @param clients the number of clients at the same time
   * @param rounds the number of rounds of all accesses per client; null if {@code length} ends the
   *     measurement
   * @param length the duration; null if {@code rounds} ends the measurement
   * @param warmUp the number of rounds per client before the measurement starts
   * @param sink receives each measured access
   */
  public record BenchPlan(
      List<BenchAccess> accesses,
      int clients,
      @Nullable Long rounds,
      @Nullable Duration length,
      int warmUp,
      BenchListener sink) {}

  /** Receives each measured access, from the threads of all clients. */
  @FunctionalInterface
  public interface BenchListener {
    /**
     * Called after each measured access.
     *
     * @param nanos the time since the measurement started, in ns
     * @param client the number of the client, from 1
     * @param took the duration of the access, in ns
     * @param failure the failure; empty if the access succeeded
     * @throws OutputException if the access cannot be written, which ends the measurement
     */
    void add(long nanos, int client, BenchAccess access, long took, String failure);
  }

  /**
   * The result of a measurement.
   *
   * @param tallies one tally per access, in the order of the plan
   * @param duration how long the measurement ran
   * @param complaints the messages of the clients that gave up
   */
  public record Result(List<BenchTally> tallies, Duration duration, List<String> complaints) {}

  /**
   * Connects all clients.
   *
   * @throws CrossComException if a client cannot connect
   */
  public Bench(BenchPlan plan, ClientConfig config) throws CrossComException {
    this.plan = plan;
    this.warm = new CountDownLatch(plan.clients());
    this.done = new CountDownLatch(plan.clients());
    try {
      for (int i = 1; i <= plan.clients(); i++) {
        clients.add(new Client(i, new CrossComClient(config)));
      }
    } catch (CrossComException | RuntimeException e) {
      closeQuietly();
      throw e;
    }
  }

  /**
   * Runs the measurement and blocks until it ends.
   *
   * @param isStopped returns whether the user wants to stop; an interrupt of this thread stops it
   *     too, and the interrupt flag stays set
   * @throws OutputException if the sink failed
   */
  public Result run(BooleanSupplier isStopped) {
    for (Client client : clients) {
      Thread thread = new Thread(client, "bench-" + client.number);
      thread.setDaemon(true);
      thread.start();
    }
    boolean interrupted = !await(warm, isStopped);
    begin = System.nanoTime();
    Duration length = plan.length();
    end = length == null ? Long.MAX_VALUE : length.toNanos();
    go.countDown();
    interrupted |= !await(done, isStopped);
    Duration duration = Duration.ofNanos(System.nanoTime() - begin);
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
    RuntimeException failure = broken.get();
    if (failure != null) {
      throw failure;
    }
    return result(duration);
  }

  /**
   * Waits for the latch; returns false if interrupted, which stops the clients as a signal does.
   */
  private boolean await(CountDownLatch latch, BooleanSupplier isStopped) {
    boolean interrupted = false;
    while (true) {
      stopped |= interrupted || isStopped.getAsBoolean();
      try {
        if (latch.await(TICK_MILLIS, TimeUnit.MILLISECONDS)) {
          return !interrupted;
        }
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
  }

  private Result result(Duration duration) {
    List<BenchTally> tallies = new ArrayList<>();
    for (int i = 0; i < plan.accesses().size(); i++) {
      BenchTally all = new BenchTally();
      for (Client client : clients) {
        all.add(client.tallies.get(i));
      }
      tallies.add(all);
    }
    List<String> complaints =
        clients.stream().map(c -> c.complaint).filter(text -> !text.isEmpty()).toList();
    return new Result(tallies, duration, complaints);
  }

  @Override
  public void close() throws IOException {
    stopped = true;
    for (Client client : clients) {
      client.client.close();
    }
  }

  private void closeQuietly() {
    try {
      close();
    } catch (IOException e) {
      // the failure before it counts
    }
  }

  /** A client; only its own thread uses it until it is done. */
  private final class Client implements Runnable {
    private final int number;
    private final List<BenchTally> tallies;
    private volatile CrossComClient client;
    private int failuresInSuccession;
    private String complaint = "";

    Client(int number, CrossComClient client) {
      this.number = number;
      this.client = client;
      this.tallies = plan.accesses().stream().map(access -> new BenchTally()).toList();
    }

    @Override
    public void run() {
      try {
        for (int i = 0; i < plan.warmUp() && isActive(); i++) {
          round(false);
        }
        warm.countDown();
        go.await();
        Long rounds = plan.rounds();
        for (long i = 0; (rounds == null || i < rounds) && isActive(); i++) {
          round(true);
        }
      } catch (RuntimeException e) {
        broken.compareAndSet(null, e);
        stopped = true;
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      } finally {
        warm.countDown();
        done.countDown();
      }
    }

    private boolean isActive() {
      return !stopped
          && complaint.isEmpty()
          && (end == Long.MAX_VALUE || System.nanoTime() - begin < end);
    }

    private void round(boolean measured) {
      String value = null;
      for (int i = 0; i < tallies.size() && isActive(); i++) {
        BenchAccess access = plan.accesses().get(i);
        if (!access.write()) {
          value = null;
        } else if (value == null) {
          // the read failed, so there is no value to write back
          continue;
        }
        long start = System.nanoTime();
        CrossComException failure = null;
        try {
          value = exchange(access, value);
        } catch (CrossComException e) {
          failure = e;
          value = null;
        }
        long took = System.nanoTime() - start;
        if (measured) {
          note(i, start, took, failure);
        }
        recoverFrom(failure);
      }
    }

    /** Does an access and returns the value. */
    private String exchange(BenchAccess access, @Nullable String value) throws CrossComException {
      try {
        if (value == null) {
          return client.readText(access.name());
        }
        client.writeText(access.name(), value);
        return value;
      } catch (CrossComException e) {
        throw e;
      } catch (IOException e) {
        // the client throws no other IOException
        throw new UncheckedIOException(e);
      }
    }

    private void note(int i, long start, long took, @Nullable CrossComException failure) {
      String kind = failure == null ? "" : BenchTally.kind(failure);
      if (failure == null) {
        tallies.get(i).add(took);
      } else {
        tallies.get(i).addFailure(kind);
      }
      plan.sink().add(start - begin, number, plan.accesses().get(i), took, kind);
    }

    /**
     * Reconnects if the failure may have broken the connection. No measurement includes this time.
     */
    private void recoverFrom(@Nullable CrossComException failure) {
      if (failure == null || BenchTally.keepsConnection(failure)) {
        failuresInSuccession = 0;
        return;
      }
      failuresInSuccession++;
      if (failuresInSuccession == MAX_FAILURES) {
        complaint = complaint(failure);
        return;
      }
      try {
        client.close();
        client = new CrossComClient(client.getConfig());
      } catch (IOException e) {
        complaint = complaint(e);
      }
    }

    private String complaint(IOException e) {
      return "client " + number + " gave up: " + e.getMessage();
    }
  }
}
