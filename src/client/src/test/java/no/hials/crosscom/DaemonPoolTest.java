package no.hials.crosscom;

import static java.util.concurrent.TimeUnit.SECONDS;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionHandler;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.SynchronousQueue;
import no.hials.crosscom.internal.exchange.DaemonPool;
import no.hials.crosscom.internal.exchange.DaemonThreads;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class DaemonPoolTest {
  private final ScheduledThreadPoolExecutor timer =
      new ScheduledThreadPoolExecutor(1, DaemonThreads.named("timer"));
  private final CountDownLatch failedStarts = new CountDownLatch(3);
  private volatile boolean exhausted;

  @AfterEach
  void stop() {
    timer.shutdownNow();
  }

  /** Fails as a thread does that cannot be started. */
  private Thread thread(Runnable task) {
    if (exhausted) {
      failedStarts.countDown();
      throw new OutOfMemoryError("unable to create native thread");
    }
    Thread thread = new Thread(task, "scarce");
    thread.setDaemon(true);
    return thread;
  }

  private DaemonPool pool(int few, int most, RejectedExecutionHandler handler) {
    return new DaemonPool(
        few,
        most,
        few == 0 ? new SynchronousQueue<>() : new LinkedBlockingQueue<>(),
        this::thread,
        handler,
        timer);
  }

  private static void refuse(Runnable task, Object pool) {
    throw new AssertionError("refused " + task);
  }

  @Test
  void aTaskWaitsUntilAThreadCanBeStarted() throws Exception {
    DaemonPool pool = pool(2, 2, DaemonPoolTest::refuse);
    CompletableFuture<Boolean> ranExhausted = new CompletableFuture<>();
    exhausted = true;

    pool.execute(() -> ranExhausted.complete(exhausted));
    assertThat(failedStarts.await(10, SECONDS)).isTrue();
    exhausted = false;

    assertThat(ranExhausted.get(10, SECONDS)).isFalse();
  }

  @Test
  void tasksRunOnceInTheThreadThatThereIs() throws Exception {
    DaemonPool pool = pool(2, 2, DaemonPoolTest::refuse);
    CompletableFuture<Void> started = new CompletableFuture<>();
    CompletableFuture<Void> end = new CompletableFuture<>();
    pool.execute(
        () -> {
          started.complete(null);
          end.join();
        });
    started.get(10, SECONDS);
    exhausted = true;
    Queue<Integer> ran = new ConcurrentLinkedQueue<>();
    CompletableFuture<Void> last = new CompletableFuture<>();

    for (int i = 0; i < 3; i++) {
      int number = i;
      pool.execute(() -> ran.add(number));
    }
    pool.execute(() -> last.complete(null));
    end.complete(null);

    last.get(10, SECONDS);
    assertThat(ran).containsExactly(0, 1, 2);
  }

  @Test
  void aTaskThatCannotWaitIsRejected() {
    Queue<Runnable> rejected = new ConcurrentLinkedQueue<>();
    DaemonPool pool = pool(0, 2, (task, unused) -> rejected.add(task));
    exhausted = true;
    Runnable task = () -> {};

    pool.execute(task);

    assertThat(rejected).containsExactly(task);
  }
}
