package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.io.IOException;
import java.time.Duration;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComTimeoutException;
import no.hials.crosscom.control.SubmitOutputs;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import org.junit.jupiter.api.Test;

/**
 * Shows how to test the software of a cell without the cell: the annotation starts a simulated
 * controller for each test, with the programs of the real controller.
 */
class UnitTestYourCellTest {

  /** The code under test: it closes a gripper, and checks that it holds a part. */
  static final class Gripper {
    private static final int CLOSE = 3;
    private static final int PART_HELD = 2;

    private final SubmitOutputs signals;

    Gripper(CrossComClient client) {
      signals = new SubmitOutputs(client);
    }

    void close() throws IOException {
      if (signals.input(PART_HELD)) {
        throw new IllegalStateException("the gripper must be empty, holds a part");
      }
      signals.setOutput(CLOSE, true);
    }
  }

  @KukaController(
      dataLists = "../krl/config.dat",
      programs = "../krl/jov_sps.sub",
      submit = "JOV_SPS",
      clock = "stepped") // the test advances the time, so every run is the same
  private MockServer robot;

  private CrossComClient connect(MockServer server) throws IOException {
    return new CrossComClient(
        ClientConfig.create(
            server.host(), cfg -> cfg.port(server.port()).requestTimeout(Duration.ofMillis(500))));
  }

  private void letTimePass() {
    robot.controller().step(Duration.ofMillis(48));
  }

  @Test
  void closingSwitchesTheOutput() throws Exception {
    letTimePass(); // until the submit program is in its loop
    try (CrossComClient client = connect(robot)) {
      new Gripper(client).close();
      letTimePass();
      assertThat(robot.variables().get("$OUT[3]")).isEqualTo("TRUE");
    }
  }

  @Test
  void aGripperThatHoldsAPartIsNotClosed() throws Exception {
    robot.variables().set("$IN[2]", "TRUE"); // the sensor of the cell
    letTimePass();
    try (CrossComClient client = connect(robot)) {
      assertThatIllegalStateException()
          .isThrownBy(() -> new Gripper(client).close())
          .withMessage("the gripper must be empty, holds a part");
    }
    assertThat(robot.requests()).noneMatch(RecordedRequest::isWrite);
  }

  @Test
  void aLostAnswerDoesNotLeadToASecondWrite() throws Exception {
    letTimePass();
    robot.fault(RecordedRequest::isWrite, Fault.dropAnswer());
    try (CrossComClient client = connect(robot)) {
      assertThatExceptionOfType(CrossComTimeoutException.class)
          .isThrownBy(() -> new Gripper(client).close())
          .satisfies(e -> assertThat(e.isOutcomeUnknown()).isTrue());
    }
    assertThat(robot.requests()).filteredOn(RecordedRequest::isWrite).hasSize(1);
  }

  @Test
  void withoutTheSubmitProgramNothingIsSwitched(
      @KukaController(dataLists = "../krl/config.dat") MockServer idle) throws Exception {
    try (CrossComClient client = connect(idle)) {
      assertThatExceptionOfType(CrossComAccessException.class)
          .isThrownBy(() -> new Gripper(client).close())
          .withMessageContaining("JOV_IN[2]"); // without a value
    }
    assertThat(idle.requests()).noneMatch(RecordedRequest::isWrite);
  }
}
