package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.util.List;
import no.hials.crosscom.mock.FailedRead;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.UnknownFunction;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import org.junit.jupiter.api.Test;

/** Detects the type of a server that fails to answer the first question. */
class ServerDetectionTest extends RobotTest {
  private ServerType detected() throws Exception {
    return client.getServer().type();
  }

  private List<MessageType> types() {
    return robot.requests().stream()
        .map(r -> r.request() == null ? MessageType.FEATURES : r.request().type())
        .toList();
  }

  @Test
  void aFailureInAnswerToTheTypeDoesNotHideTheServer() throws Exception {
    robot.enqueue(Fault.answer("", Tail.FAILURE_ZERO));

    assertThat(detected()).isEqualTo(server);
    assertThat(detected()).isEqualTo(server);
    assertThat(robot.requests()).extracting(RecordedRequest::connection).containsOnly(1);
  }

  @Test
  void aKukavarproxyThatAnswersUnknownNamesWithAFailureIsDetected() throws Exception {
    try (MockServer old =
            MockServer.start(
                cfg -> cfg.server(ServerType.KUKAVARPROXY).failedRead(FailedRead.FAILURE));
        CrossComClient other = new CrossComClient(old.host(), old.port())) {
      assertThat(other.getServer().type()).isEqualTo(ServerType.KUKAVARPROXY);
      assertThat(other.readText("MYINT")).isEqualTo("0");
      assertThat(old.requests()).extracting(RecordedRequest::connection).containsOnly(1);
    }
  }

  @Test
  void aKukavarproxyWhoseTypeIsSetReadsAndWritesTextsWithoutBeingAskedForIt() throws Exception {
    try (MockServer old =
            MockServer.start(
                cfg ->
                    cfg.server(ServerType.KUKAVARPROXY)
                        .failedRead(FailedRead.FAILURE)
                        .unknownFunction(UnknownFunction.CLOSE));
        CrossComClient other =
            new CrossComClient(
                ClientConfig.create(
                    old.host(), c -> c.port(old.port()).server(ServerType.KUKAVARPROXY)))) {
      other.writeText("MYSTRING[]", "\"Größe\"");

      assertThat(other.readText("MYSTRING[]")).isEqualTo("\"Größe\"");
      assertThat(other.getServer().type()).isEqualTo(ServerType.KUKAVARPROXY);
      assertThat(old.requests())
          .extracting(r -> r.request().type())
          .containsExactly(MessageType.WRITE, MessageType.READ);
    }
  }

  @Test
  void aC3BridgeWhoseTypeIsSetGetsTextsInUtf16WithoutBeingAskedForIt() throws Exception {
    try (MockServer bridge = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE));
        CrossComClient other =
            new CrossComClient(
                ClientConfig.create(
                    bridge.host(), c -> c.port(bridge.port()).server(ServerType.C3_BRIDGE)))) {
      other.writeText("MYSTRING[]", "\"日\"");

      assertThat(bridge.variables().get("MYSTRING[]")).isEqualTo("\"日\"");
      assertThat(bridge.requests())
          .extracting(r -> r.request().type())
          .containsExactly(MessageType.WRITE_UTF16);
    }
  }

  @Test
  void aServerThatFailsBothQuestionsIsNotTakenForAnyType() throws Exception {
    robot.enqueue(Fault.answer("", Tail.FAILURE), Fault.raw("0002 0004 0E 0000 00"));

    assertThatExceptionOfType(CrossComRefusedException.class)
        .isThrownBy(this::detected)
        .withMessageContaining("its type is unknown: set it in ClientConfig (server), or");
    assertThat(detected()).as("the connection is usable").isEqualTo(server);
  }

  @Test
  void anAnswerToAnUnknownFunctionMayHaveTheId0() throws Exception {
    robot.enqueue(Fault.answer("", Tail.FAILURE), Fault.raw("0000 0000"));

    assertThat(detected()).isEqualTo(ServerType.KUKAVARPROXY);
    assertThat(types()).containsExactly(MessageType.READ, MessageType.FEATURES);
    assertThat(client.readText("MYINT")).as("the connection is usable").isEqualTo("0");
  }

  @Test
  void theTypeStaysUnknownAfterATimeOut() throws Exception {
    client.close();
    client = client(cfg -> cfg.requestTimeout(SHORT));
    // not the next requests: on a slow computer, one can come after the time-out
    robot.fault(it -> true, Fault.drop());
    assertThatExceptionOfType(CrossComTimeoutException.class).isThrownBy(this::detected);
    robot.clearFaults();
    robot.fault(it -> it.request() instanceof ReadRequest, Fault.answer("", Tail.FAILURE));
    robot.fault(it -> true, Fault.drop());
    assertThatExceptionOfType(CrossComTimeoutException.class).isThrownBy(this::detected);

    robot.clearFaults();
    client.setSoTimeout((int) LONG.toMillis());
    assertThat(detected()).isEqualTo(server);
  }
}
