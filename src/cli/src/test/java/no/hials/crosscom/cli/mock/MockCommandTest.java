package no.hials.crosscom.cli.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.SocketException;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.RunningMock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class MockCommandTest {
  private static final int DISCOVERY_PORT = 6999;

  @Test
  void servesUntilItIsInterruptedAndThenFreesThePort() throws Exception {
    try (RunningMock mock = new RunningMock("--no-discovery")) {
      assertThat(mock.run("read", "MYINT").lines()).containsExactly("MYINT = 0");
      assertThat(mock.isRunning()).isTrue();

      assertThat(mock.stop()).isZero();
      assertThat(mock.run("read", "MYINT").code()).isEqualTo(3);
    }
  }

  @Test
  void saysThatThePortIsInUse() throws IOException {
    try (ServerSocket other = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      Cli.run("mock", "--port", "" + other.getLocalPort())
          .failsInALine(3)
          .startsWith("jopenshowvar: cannot listen on 127.0.0.1:" + other.getLocalPort() + ": ");
    }
  }

  @Test
  void saysThatTheAddressIsNotOfThisMachine() {
    // an address of the block for documentation, RFC 5737
    Cli.run("mock", "--host", "192.0.2.1", "--port", "0")
        .fails(3)
        .startsWith("jopenshowvar: cannot listen on ")
        .contains("192.0.2.1");
  }

  @Test
  void warnsOfTheNetworkUnlessOnlyThisMachineReachesIt() throws Exception {
    assertThat(MockCommand.warning(InetAddress.getByAddress(new byte[4])))
        .hasValueSatisfying(text -> assertThat(text).startsWith("warning: ").contains("password"));
    assertThat(MockCommand.warning(InetAddress.getByAddress(new byte[] {10, 0, 0, 1}))).isPresent();
    assertThat(MockCommand.warning(InetAddress.getByAddress(new byte[] {127, 0, 0, 1}))).isEmpty();
    assertThat(MockCommand.warning(InetAddress.getLoopbackAddress())).isEmpty();
  }

  // discovery

  @Test
  void listensForTheQuestionWhereControllersAre() throws Exception {
    try (RunningMock mock = new RunningMock("--discovery", "0")) {
      String line = mock.nextLine();
      assertThat(line).matches("discovery on 127\\.0\\.0\\.1:\\d+");
      int port = Integer.parseInt(line.substring(line.lastIndexOf(':') + 1));

      assertThatThrownBy(() -> new DatagramSocket(port, InetAddress.getLoopbackAddress()).close())
          .isInstanceOf(SocketException.class);
    }
  }

  @Test
  void saysThatTheDiscoveryPortThatWasAskedForIsInUse() throws Exception {
    try (DatagramSocket other = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      Cli.run("mock", "--port", "0", "--discovery", "" + other.getLocalPort())
          .fails(3)
          .startsWith("jopenshowvar: cannot listen on UDP ");
    }
  }

  @Test
  void servesWithoutDiscoveryIfTheUsualPortIsInUse() throws Exception {
    DatagramSocket other = new DatagramSocket(null);
    try (other) {
      occupy(other, DISCOVERY_PORT);
      try (RunningMock mock = new RunningMock()) {
        assertThat(mock.nextErrorLine())
            .isEqualTo("jopenshowvar: no discovery: UDP port 6999 is in use");
        assertThat(mock.nextLine()).isEqualTo("T1, no program");
      }
    }
  }

  private static void occupy(DatagramSocket socket, int port) {
    try {
      socket.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
    } catch (SocketException e) {
      // another program already occupies the port
    }
  }

  // code page

  @Test
  void carriesTextsInTheCodePageThatIsAskedFor() throws Exception {
    try (RunningMock mock = new RunningMock("--no-discovery", "--code-page", "1251")) {
      String[] write = {"MYSTRING[]", "\"Привет\"", "--charset", "windows-1251"};
      assertThat(mock.run("write", write).code()).isZero();
      assertThat(mock.read("MYSTRING[]")).isEqualTo("\"Ïðèâåò\"");
    }
    Cli.run("mock", "--port", "0", "--code-page", "7")
        .fails(2)
        .contains("codePage must be a code page of Windows such as 1252, 1251 or 936, is 7");
  }

  // robot

  @Test
  void movesTheRobotThatIsAskedFor() throws Exception {
    try (RunningMock mock = new RunningMock("--no-discovery", "--robot", "kr210 r2700-2")) {
      assertThat(mock.read("$MODEL_NAME[]")).isEqualTo("\"#KR210R2700_2 C4 FLR\"");
      assertThat(mock.read("$POS_ACT.X")).isEqualTo("1765.00");
    }
  }

  @Test
  void listsTheNamesOfTheRobotsAndTheNearestOfAnUnknownOne() {
    assertThat(Cli.run("mock", "--robots").lines())
        .hasSize(45)
        .contains("KR 6 R900 sixx", "KR 210 R2700-2");
    Cli.run("mock", "--port", "0", "--robot", "KR 210 R2700")
        .fails(2)
        .contains("no robot is named KR 210 R2700, the nearest names are KR 210 R2700-2, ");
  }

  // faults and times

  @Test
  void letsGoWrongWhatIsAskedFor() throws Exception {
    try (RunningMock mock =
        new RunningMock("--no-discovery", "--fault", "failure@2", "--fault", "answer:7@MYINT")) {
      assertThat(mock.read("MYINT")).isEqualTo("7");
      assertThat(mock.run("read", "MYREAL").code()).isEqualTo(1);
      assertThat(mock.read("MYREAL")).isEqualTo("0.0");
    }
  }

  @Test
  void drawsTheSameFaultsForTheSameSeed() throws Exception {
    List<String> read = failingOneInTwo("5");

    assertThat(read).hasSizeBetween(1, 39).isEqualTo(failingOneInTwo("5"));
    assertThat(read).isNotEqualTo(failingOneInTwo("6"));
  }

  /** Reads 40 outputs and returns the lines of those that could be read. */
  private static List<String> failingOneInTwo(String seed) throws InterruptedException {
    try (RunningMock mock =
        new RunningMock("--no-discovery", "--fault", "failure%0.5", "--seed", seed)) {
      String[] names =
          IntStream.rangeClosed(1, 40).mapToObj(i -> "$OUT[" + i + "]").toArray(String[]::new);
      return mock.run("read", names).lines();
    }
  }

  @Test
  void takesItsTimeForARequest() throws Exception {
    for (String latency : List.of("none", "1ms", "krc4", "krc4-2014")) {
      try (RunningMock mock = new RunningMock("--no-discovery", "--latency", latency)) {
        assertThat(mock.read("MYINT")).isEqualTo("0");
      }
    }
    // longer than the client waits
    try (RunningMock mock = new RunningMock("--no-discovery", "--latency", "60s")) {
      assertThat(mock.run("read", "--timeout", "20ms", "MYINT").code()).isEqualTo(4);
    }
  }

  @Test
  void letsTimePassAsFastAsItIsAskedTo() throws Exception {
    for (String speed : List.of("real", "0.5", "100", "MAX")) {
      try (RunningMock mock = new RunningMock("--no-discovery", "--speed", speed)) {
        // a timer runs as soon as its stop is taken away
        assertThat(mock.run("write", "$TIMER_STOP[1]", "FALSE").code()).isZero();
        assertThat(Stream.generate(() -> mock.read("$TIMER[1]")).anyMatch(t -> !t.equals("0")))
            .isTrue();
      }
    }
  }
}
