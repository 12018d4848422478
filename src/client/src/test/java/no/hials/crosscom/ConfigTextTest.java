package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.time.Duration;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.Stream;
import no.hials.crosscom.c3.DiscoveryConfig;
import no.hials.crosscom.c3.TransferConfig;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Configurations are values. */
class ConfigTextTest {
  static Stream<Arguments> configurations() {
    InetAddress target = InetAddress.getLoopbackAddress();
    return Stream.of(
        arguments(
            i -> ClientConfig.create("robot", cfg -> cfg.port(7000 + i)),
            "ClientConfig{host=robot, port=7001, server=Optional.empty, connectTimeout=PT5S, "),
        arguments(
            i -> WatchConfig.create(List.of("A"), cfg -> cfg.period(Duration.ofMillis(10 + i))),
            "WatchConfig{names=[A], handles=[], period=PT0.011S, "),
        arguments(
            i -> TransferConfig.create(cfg -> cfg.overwrite(i == 1)),
            "TransferConfig{overwrite=true, flags=[], "),
        arguments(
            i -> DiscoveryConfig.create(cfg -> cfg.addresses(target).standardPort(7000 + i)),
            "DiscoveryConfig{targets=[" + target + "], timeout=PT1S, localAddress=null, "));
  }

  private static Arguments arguments(IntFunction<Object> config, String text) {
    return Arguments.of(config, text);
  }

  @ParameterizedTest
  @MethodSource("configurations")
  void configurationsAreEqualByTheirOptionsAndPrintThem(IntFunction<Object> config, String text) {
    assertThat(config.apply(1))
        .isEqualTo(config.apply(1))
        .hasSameHashCodeAs(config.apply(1))
        .isNotEqualTo(config.apply(0));
    assertThat(config.apply(1).toString()).startsWith(text);
  }
}
