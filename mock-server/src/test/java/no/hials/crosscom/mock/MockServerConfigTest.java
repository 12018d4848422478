package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.Version;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.simulator.FileTree;
import no.hials.crosscom.simulator.SimulationClock;
import org.junit.jupiter.api.Test;

class MockServerConfigTest {

  private static void assertRefused(Consumer<MockServerConfig.Builder> changes, String message) {
    assertThatThrownBy(() -> MockServerConfig.create(changes))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining(message);
  }

  private static List<Object> options(MockServerConfig config) {
    return List.of(
        config.bindAddress(),
        config.port(),
        config.failedRead(),
        config.failedWriteTail(),
        config.trimValues(),
        config.maxClients(),
        config.idleTimeout(),
        config.maxAggregateLength(),
        config.recordedRequests(),
        config.joinSplitRequests(),
        config.oneAtATime(),
        config.pendingRequests(),
        config.unknownFunction(),
        config.ping(),
        config.latency(),
        config.discoveryPort(),
        config.discoveryReplyPort(),
        config.clock(),
        config.robot(),
        config.server(),
        config.version(),
        config.computerName(),
        config.standardDiscoveryPort(),
        config.files());
  }

  @Test
  void behavesAsKukavarproxyByDefault() {
    assertThat(options(MockServerConfig.create(cfg -> {})))
        .isEqualTo(
            List.of(
                InetAddress.getLoopbackAddress(),
                0,
                FailedRead.EMPTY_SUCCESS,
                Tail.FAILURE,
                true,
                10,
                Duration.ofSeconds(30),
                255,
                10_000,
                true,
                true,
                PendingRequests.WAIT,
                UnknownFunction.EMPTY_ANSWER,
                true,
                Latency.none(),
                OptionalInt.empty(),
                7000,
                SimulationClock.real(),
                RobotModel.kr6r900sixx(),
                ServerType.KUKAVARPROXY,
                new Version(1, 4, 0),
                "KRC4",
                OptionalInt.empty(),
                Optional.empty()));
  }

  @Test
  void takesWhatIsSet() throws Exception {
    FileTree files = FileTree.inMemory();
    InetAddress any = InetAddress.getByAddress(new byte[4]);
    RobotModel otherLimits =
        RobotModel.kr6r900sixx()
            .withLimits(Axis.of(-9, -9, -9, -9, -9, -9), Axis.of(9, 9, 9, 9, 9, 9));
    assertThat(
            options(
                MockServerConfig.create(
                    cfg ->
                        cfg.bindAddress(any)
                            .port(65_535)
                            .failedRead(FailedRead.FAILURE)
                            .failedWriteTail(Tail.FAILURE_ZERO)
                            .trimValues(false)
                            .maxClients(0)
                            .idleTimeout(Duration.ZERO)
                            .maxAggregateLength(0)
                            .recordedRequests(0)
                            .joinSplitRequests(false)
                            .oneAtATime(false)
                            .pendingRequests(PendingRequests.DROP_OF_SAME_CLIENT)
                            .unknownFunction(UnknownFunction.CLOSE)
                            .ping(false)
                            .latency(Latency.krc4(1))
                            .discoveryPort(65_535)
                            .discoveryReplyPort(0)
                            .clock(SimulationClock.stepped())
                            .robot(otherLimits)
                            .server(ServerType.C3_BRIDGE)
                            .version(new Version(1, 1, 2))
                            .computerName("VM")
                            .standardDiscoveryPort(1)
                            .files(files))))
        .isEqualTo(
            List.of(
                any,
                65_535,
                FailedRead.FAILURE,
                Tail.FAILURE_ZERO,
                false,
                0,
                Duration.ZERO,
                0,
                0,
                false,
                false,
                PendingRequests.DROP_OF_SAME_CLIENT,
                UnknownFunction.CLOSE,
                false,
                Latency.krc4(1),
                OptionalInt.of(65_535),
                0,
                SimulationClock.stepped(),
                otherLimits,
                ServerType.C3_BRIDGE,
                new Version(1, 1, 2),
                "VM",
                OptionalInt.of(1),
                Optional.of(files)));
  }

  @Test
  void isAsOnTheControllerWhateverWasSetBeforeButListensWhereItWasTold() {
    MockServerConfig config =
        MockServerConfig.create(
            cfg ->
                cfg.port(5)
                    .recordedRequests(6)
                    .failedRead(FailedRead.FAILURE)
                    .failedWriteTail(Tail.FAILURE_ZERO)
                    .trimValues(false)
                    .maxClients(0)
                    .idleTimeout(Duration.ZERO)
                    .maxAggregateLength(0)
                    .oneAtATime(false)
                    .unknownFunction(UnknownFunction.CLOSE)
                    .ping(false)
                    .discoveryPort(7)
                    .discoveryReplyPort(8)
                    .clock(SimulationClock.stepped())
                    .asOnTheController(9));
    assertThat(options(config))
        .isEqualTo(
            List.of(
                InetAddress.getLoopbackAddress(),
                5,
                FailedRead.EMPTY_SUCCESS,
                Tail.FAILURE,
                true,
                10,
                Duration.ofSeconds(30),
                255,
                6,
                false,
                true,
                PendingRequests.DROP_OF_SAME_CLIENT,
                UnknownFunction.EMPTY_ANSWER,
                true,
                Latency.krc4(9),
                OptionalInt.of(7),
                8,
                SimulationClock.stepped(),
                RobotModel.kr6r900sixx(),
                ServerType.KUKAVARPROXY,
                new Version(1, 4, 0),
                "KRC4",
                OptionalInt.empty(),
                Optional.empty()));
  }

  @Test
  void behavesAsC3BridgeInAnyOrder() {
    List<Object> expected =
        List.of(
            InetAddress.getLoopbackAddress(),
            0,
            FailedRead.FAILURE_ZERO,
            Tail.FAILURE_ZERO,
            false,
            0,
            Duration.ZERO,
            255,
            10_000,
            true,
            true,
            PendingRequests.WAIT,
            UnknownFunction.CLOSE,
            true,
            Latency.krc4(3),
            OptionalInt.empty(),
            7000,
            SimulationClock.real(),
            RobotModel.kr6r900sixx(),
            ServerType.C3_BRIDGE,
            new Version(1, 4, 0),
            "KRC4",
            OptionalInt.empty(),
            Optional.empty());
    assertThat(
            options(
                MockServerConfig.create(
                    cfg -> cfg.maxClients(3).server(ServerType.C3_BRIDGE).asOnTheController(3))))
        .isEqualTo(expected);
    assertThat(
            options(
                MockServerConfig.create(
                    cfg ->
                        cfg.asOnTheController(3).server(ServerType.C3_BRIDGE).trimValues(false))))
        .isEqualTo(expected);
  }

  @Test
  void refusesWhatIsOutOfRange() {
    assertRefused(cfg -> cfg.port(-1), "port must be 0 to 65535, is -1");
    assertRefused(cfg -> cfg.port(65_536), "port must be 0 to 65535, is 65536");
    assertRefused(cfg -> cfg.failedWriteTail(Tail.SUCCESS), "failedWriteTail must say failure");
    assertRefused(cfg -> cfg.maxClients(-1), "maxClients");
    assertRefused(cfg -> cfg.idleTimeout(Duration.ofNanos(-1)), "idleTimeout");
    assertRefused(cfg -> cfg.idleTimeout(Duration.ofDays(25)), "idleTimeout");
    assertRefused(cfg -> cfg.maxAggregateLength(-1), "maxAggregateLength");
    assertRefused(cfg -> cfg.recordedRequests(-1), "recordedRequests");
    assertRefused(cfg -> cfg.recordedBytes(-1), "recordedBytes");
    assertRefused(cfg -> cfg.discoveryPort(-1), "discoveryPort must be 0 to 65535, is -1");
    assertRefused(cfg -> cfg.discoveryPort(65_536), "discoveryPort");
    assertRefused(cfg -> cfg.discoveryReplyPort(65_536), "discoveryReplyPort");
    assertRefused(cfg -> cfg.version(new Version(0, 9, 0)), "version must be 1.0 to 255.255");
    assertRefused(cfg -> cfg.version(new Version(256, 0, 0)), "version");
    assertRefused(cfg -> cfg.version(new Version(1, 256, 0)), "version");
    assertRefused(cfg -> cfg.computerName("x".repeat(256)), "computerName");
    assertRefused(
        cfg -> cfg.server(ServerType.C3_BRIDGE).standardDiscoveryPort(-1), "standardDiscoveryPort");
    assertRefused(cfg -> cfg.standardDiscoveryPort(0), "needs server C3_BRIDGE");
    assertRefused(
        cfg -> cfg.oneAtATime(false).pendingRequests(PendingRequests.DROP), "needs oneAtATime");
  }
}
