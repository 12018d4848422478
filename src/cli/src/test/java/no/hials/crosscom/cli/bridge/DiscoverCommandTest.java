package no.hials.crosscom.cli.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.util.Arrays;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DiscoverCommandTest {
  private static final String TIME = "200ms";

  private static MockServer bridge() throws IOException {
    return MockServer.start(
        cfg ->
            cfg.server(ServerType.C3_BRIDGE)
                .standardDiscoveryPort(0)
                .discoveryPort(0)
                .discoveryReplyPort(0));
  }

  private static String ports(MockServer server, int reply) {
    int legacy = server.discoveryPort().getAsInt();
    return server.standardDiscoveryPort().orElse(legacy) + "," + legacy + "," + reply;
  }

  private static Cli.Result discover(String ports, String... options) {
    String[] args = {"discover", "--address", "127.0.0.1", "--timeout", TIME, "--ports", ports};
    String[] all = Arrays.copyOf(args, args.length + options.length);
    System.arraycopy(options, 0, all, args.length, options.length);
    return Cli.run(all);
  }

  @Test
  void printsWhoAnswered() throws IOException {
    try (MockServer server = bridge()) {
      discover(ports(server, 0))
          .succeeds()
          .containsExactly(
              "MODEL                  SERIAL  SERVER     VERSION  ADDRESS",
              "#KR6R900 C4SR FLR 230  736512  C3 Bridge      1.4  127.0.0.1:" + server.port());
    }
  }

  @Test
  void findsKukavarproxyInLegacyModeOnly() throws IOException {
    try (MockServer server = MockServer.start(cfg -> cfg.discoveryPort(0).discoveryReplyPort(0))) {
      assertThat(discover(ports(server, 0), "--legacy", "--json").lines())
          .containsExactly(
              "{\"model\":\"#KR6R900 C4SR FLR 230\",\"serial\":\"736512\",\"type\":\"KUKAVARPROXY\","
                  + "\"version\":null,\"host\":\"127.0.0.1\",\"port\":7000}");
    }
  }

  @Test
  void printsJson() throws IOException {
    try (MockServer server = bridge()) {
      assertThat(discover(ports(server, 0), "--no-legacy", "--json").lines())
          .containsExactly(
              "{\"model\":\"#KR6R900 C4SR FLR 230\",\"serial\":\"736512\",\"type\":\"C3_BRIDGE\","
                  + "\"version\":\"1.4\",\"host\":\"127.0.0.1\",\"port\":"
                  + server.port()
                  + "}");
    }
  }

  @Test
  void saysThatNobodyAnswered() throws IOException {
    try (DatagramSocket silent = new DatagramSocket(0)) {
      discover(silent.getLocalPort() + "," + silent.getLocalPort() + ",0")
          .failsInLines(3)
          .containsExactly("jopenshowvar: no server answered within 200 ms");
    }
  }

  @Test
  void goesOnInStandardModeIfThePortOfTheLegacyModeIsTaken() throws IOException {
    try (MockServer server = bridge();
        DatagramSocket other = new DatagramSocket(null)) {
      other.bind(new InetSocketAddress(0));

      Cli.Result result = discover(ports(server, other.getLocalPort()));

      assertThat(result.lines()).hasSize(2);
      assertThat(result.errLines())
          .singleElement()
          .asString()
          .startsWith("jopenshowvar: standard mode only: cannot listen on UDP port");
      assertThat(result.code()).isZero();
    }
  }

  @Test
  void failsIfTheLegacyModeIsInsistedOnAndItsPortIsTaken() throws IOException {
    try (MockServer server = bridge();
        DatagramSocket other = new DatagramSocket(null)) {
      other.bind(new InetSocketAddress(0));

      discover(ports(server, other.getLocalPort()), "--legacy")
          .fails(3)
          .startsWith("jopenshowvar: cannot listen on UDP port");
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--address ::1 | --address needs an IPv4 address",
        "--interface nosuchinterface | this computer has no network interface nosuchinterface",
        "--interface lo --address | Missing required parameter for option '--address'",
        "--ports 1,2 | --ports needs three numbers",
        "--ports 0,1,2 | of which only the last may be 0",
        "--ports 1,2,x | must be 0 to 65535, is x",
        "--timeout 0 | must be 1ms",
        "--mock | unknown option: '--mock'"
      })
  void saysWhatIsWrongWithTheUsage(String options, String message) {
    Cli.Result result = Cli.run(("discover " + options).split(" "));

    assertThat(result.errLines().get(0)).containsIgnoringCase(message);
    assertThat(result.code()).isEqualTo(2);
  }
}
