package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.internal.exchange.DaemonThreads;
import no.hials.crosscom.internal.exchange.GrowingPool;
import org.junit.jupiter.api.Test;

/** The threads of listeners while many of them are blocked. */
class BlockedListenersTest {
  @Test
  void manyBlockedListenersDelayAnotherOneByAFewChecksOnly() throws Exception {
    ScheduledThreadPoolExecutor timer =
        new ScheduledThreadPoolExecutor(1, DaemonThreads.named("timer"));
    GrowingPool pool = new GrowingPool(256, "listener", timer);
    CountDownLatch release = new CountDownLatch(1);
    CountDownLatch called = new CountDownLatch(1);
    for (int i = 0; i < 250; i++) {
      pool.execute(
          () -> {
            try {
              release.await();
            } catch (InterruptedException e) {
              Thread.currentThread().interrupt();
            }
          });
    }
    pool.execute(called::countDown);

    assertThat(called.await(60, TimeUnit.SECONDS)).isTrue();
    // 16 threads, and one more for each check, would need 235 checks
    assertThat(timer.getCompletedTaskCount()).isLessThan(150);
    release.countDown();
    pool.endIdleThreads();
    timer.shutdown();
  }
}
