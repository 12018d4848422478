package no.hials.crosscom.cell;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class HostAndPortTest {
  @ParameterizedTest
  @CsvSource({
    "172.31.1.147, 172.31.1.147,",
    "127.0.0.1:7001, 127.0.0.1, 7001",
    "krc:1, krc, 1",
    "::1, ::1,",
    "fe80::1:7000, fe80::1:7000,",
    "::, ::,",
    "[::1], ::1,",
    "[::1]:65535, ::1, 65535",
    "fe80::1%eth0, fe80::1%eth0,",
    "[::ffff:127.0.0.1%2]:7001, ::ffff:127.0.0.1%2, 7001",
    "[krc]:1, krc, 1"
  })
  void findsThePortAfterTheHost(String text, String host, Integer port) {
    assertThat(HostAndPort.parse(text)).isEqualTo(new HostAndPort(host, port));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        " ",
        ":7000",
        "[]:7000",
        "[::1",
        "h:",
        "127.0.0.1:",
        "a b",
        "::1%",
        "http://h",
        "http://127.0.0.1:7110",
        "h:7000/x"
      })
  void refusesOtherTextsWithTheForms(String text) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> HostAndPort.parse(text))
        .withMessage("must be HOST, HOST:PORT or [IPV6]:PORT, is '" + text + "'");
  }

  @Test
  void aNumberIsNoAddressToListenOn() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> HostAndPort.listening("9464", 1))
        .withMessage("must be HOST or HOST:PORT, such as 127.0.0.1:9464, is '9464'");
  }

  @ParameterizedTest
  @ValueSource(strings = {"0", "65536", "x"})
  void refusesAWrongPort(String port) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> HostAndPort.parse("h:" + port))
        .withMessage("the port must be 1 to 65535, is " + port);
  }

  @Test
  void refusesTwoDifferentPorts() {
    HostAndPort address = HostAndPort.parse("h:7001");

    assertThat(address.portOr(null, 7000)).isEqualTo(7001);
    assertThat(address.portOr(7001, 7000)).isEqualTo(7001);
    assertThat(HostAndPort.parse("h").portOr(7002, 7000)).isEqualTo(7002);
    assertThat(HostAndPort.parse("h").portOr(null, 7000)).isEqualTo(7000);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> address.portOr(7002, 7000))
        .withMessage("names the port 7001, but the port is set to 7002");
  }
}
