package no.hials.crosscom.control;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import no.hials.crosscom.mock.MockServerConfig;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.Test;

/** With C3 Bridge, which reads the clock in the message of the position. */
class FeedbackAgeOnC3BridgeTest extends FeedbackAgeTest {
  @Override
  void configure(MockServerConfig.Builder cfg) {
    super.configure(cfg);
    cfg.server(ServerType.C3_BRIDGE);
  }

  @Override
  @Test
  void oldPositionsStopTheRobotAtTheNextCheckOfTheClock() throws Exception {
    assertStopsAtOldPositions(12); // each reading is checked
  }

  @Override
  @Test
  void theClockCostsAFewAccessesASecond() throws Exception {
    run("ext_move_axis.src");
    server.clearRequests();
    runLoop(config(cfg -> cfg.duration(Duration.ofSeconds(3))), SLOW);

    assertThat(server.requests())
        .filteredOn(r -> r.names().contains("$ROB_TIMER"))
        .hasSizeGreaterThan(200)
        .filteredOn(r -> !r.names().contains("$AXIS_ACT"))
        .hasSize(1);
  }
}
