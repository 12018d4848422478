package no.hials.crosscom.cli.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Optional;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.FaultRule;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.Test;

class InfoCommandTest {
  private static MockServer bridge() throws IOException {
    return MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE).computerName("CELL-7"));
  }

  @Test
  void printsWhatC3BridgeSaysOfItselfAndTheRobot() throws IOException {
    try (MockServer server = bridge()) {
      Cli.Result result = Cli.runOn(server, "info");

      result.succeeds();
      assertThat(result.out())
          .containsPattern("(?m)^server +C3 Bridge Interface$")
          .containsPattern("(?m)^version +1.4$")
          .containsPattern("(?m)^build +open source$")
          .containsPattern("(?m)^host +CELL-7$")
          .containsPattern("(?m)^clock +20\\d\\d-.*Z$")
          .containsPattern("(?m)^model +#KR6R900 C4SR FLR 230$")
          .containsPattern("(?m)^serial +736512$")
          .containsPattern("(?m)^mode +#T1$")
          .containsPattern("(?m)^features +0-1 4-7 10-14 17 20-30 63$");
    }
  }

  @Test
  void printsWhatThereIsOnKukavarproxy() throws IOException {
    try (MockServer server = MockServer.start()) {
      Cli.Result result = Cli.runOn(server, "info");

      assertThat(result.out())
          .containsPattern("(?m)^server +KUKAVARPROXY$")
          .containsPattern("(?m)^version +-$")
          .containsPattern("(?m)^clock +-$")
          .containsPattern("(?m)^serial +736512$")
          .containsPattern("(?m)^features +0-3$");
      assertThat(result.code()).isZero();
    }
  }

  @Test
  void printsJson() throws IOException {
    try (MockServer server = bridge();
        MockServer old = MockServer.start()) {
      server.faults(FaultRule.parse("failure@$KR_SERIALNO", 1));

      assertThat(Cli.runOn(server, "info", "--json").lines())
          .singleElement()
          .asString()
          .startsWith("{\"server\":\"C3 Bridge Interface\",\"version\":\"1.4\",\"build\":\"open")
          .contains("\"host\":\"CELL-7\"", "\"serial\":null", "\"mode\":\"#T1\"")
          .endsWith(
              "\"features\":[0,1,4,5,6,7,10,11,12,13,14,17,20,21,22,23,24,25,26,27,28,29,30,63]}");
      assertThat(Cli.runOn(old, "info", "--json").lines())
          .containsExactly(
              "{\"server\":\"KUKAVARPROXY\",\"version\":null,\"build\":null,\"host\":null,"
                  + "\"clock\":null,\"model\":\"#KR6R900 C4SR FLR 230\",\"serial\":\"736512\","
                  + "\"mode\":\"#T1\",\"features\":[0,1,2,3]}");
    }
  }

  @Test
  void saysWhatToCheckIfNothingAnswers() throws IOException {
    try (MockServer server = MockServer.start()) {
      server.faults(request -> Optional.of(Fault.drop()));
      Cli.runOn(server, "info", "--timeout", "100ms")
          .failsInLines(4)
          .last()
          .isEqualTo("check that KUKAVARPROXY or C3 Bridge listens on this port");
    }
  }

  @Test
  void saysThatAnAnswerIsNotAValue() throws IOException {
    try (MockServer server = bridge()) {
      server.faults(FaultRule.parse("answer:{X@$MODEL_NAME[]", 1));

      assertThat(Cli.runOn(server, "info").err())
          .startsWith(
              "jopenshowvar: $MODEL_NAME[]: the answer of the controller is not a KRL value: ");
    }
  }

  @Test
  void saysThatItIsNotThere() throws IOException {
    MockServer server = bridge();
    server.close();

    Cli.runOn(server, "info").fails(3);
  }
}
