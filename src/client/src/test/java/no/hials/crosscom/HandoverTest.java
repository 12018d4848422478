package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.time.Duration;
import no.hials.crosscom.mock.Fault;
import org.junit.jupiter.api.Test;

/** Uses a connection by threads and by the selector loop in turn. */
class HandoverTest extends RobotTest {
  private static final int ROUNDS = 100;

  private long pings() {
    return robot.requests().stream().filter(request -> request.name().equals("PING")).count();
  }

  private void awaitPing(long before) {
    while (pings() == before) {
      Thread.onSpinWait();
    }
  }

  @Test
  void accessesBetweenKeepAlivesHaveTheRightValues() throws Exception {
    try (CrossComClient its = client(cfg -> cfg.keepAlive(Duration.ofMillis(1)))) {
      for (int i = 0; i < ROUNDS; i++) {
        long before = pings();
        its.writeInt("MYINT", i);
        assertThat(its.readInt("MYINT")).isEqualTo(i);
        awaitPing(before);
      }
      assertThat(its.statistics().losses()).isZero();
    }
  }

  @Test
  void aCallAfterAKeepAliveTimesOutLikeAnyOther() throws Exception {
    try (CrossComClient its =
        client(cfg -> cfg.keepAlive(Duration.ofMillis(10)).requestTimeout(SHORT))) {
      awaitPing(pings());
      robot.fault(request -> request.name().equals("MYINT"), Fault.dropAnswer());

      assertThatExceptionOfType(CrossComTimeoutException.class)
          .isThrownBy(() -> its.readInt("MYINT"));
    }
  }

  @Test
  void closingAClientWhoseConnectionTheLoopHasClosesIt() throws Exception {
    assertThat(client.readInt("MYINT")).as("the other client is counted").isZero();
    int before = robot.clientCount();
    CrossComClient its = client(cfg -> cfg.keepAlive(Duration.ofMillis(1)));
    awaitPing(pings());
    its.close();
    while (robot.clientCount() > before) {
      Thread.onSpinWait();
    }
  }

  @Test
  void closingAClientJustAfterAThreadTookOverItsConnectionClosesIt() throws Exception {
    assertThat(client.readInt("MYINT")).as("the other client is counted").isZero();
    int before = robot.clientCount();
    CrossComClient its = client(cfg -> cfg.keepAlive(Duration.ofMillis(1)));
    awaitPing(pings());
    assertThat(its.readInt("MYINT")).isZero();
    its.close();
    while (robot.clientCount() > before) {
      Thread.onSpinWait();
    }
  }
}
