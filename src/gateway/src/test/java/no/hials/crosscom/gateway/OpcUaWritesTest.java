package no.hials.crosscom.gateway;

import static no.hials.crosscom.gateway.OpcUaPlant.awaitGood;
import static no.hials.crosscom.gateway.OpcUaPlant.read;
import static no.hials.crosscom.gateway.OpcUaPlant.robots;
import static no.hials.crosscom.gateway.OpcUaPlant.write;
import static no.hials.crosscom.gateway.OpcUaPlant.writeOf;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import org.eclipse.milo.opcua.sdk.client.OpcUaClient;
import org.eclipse.milo.opcua.stack.core.StatusCodes;
import org.eclipse.milo.opcua.stack.core.UaException;
import org.eclipse.milo.opcua.stack.core.types.builtin.NodeId;
import org.eclipse.milo.opcua.stack.core.types.builtin.StatusCode;
import org.eclipse.milo.opcua.stack.core.types.structured.WriteResponse;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Writes that a client sends before the earlier ones are answered. */
@Timeout(60)
class OpcUaWritesTest {
  @KukaController private MockServer robot;

  /** Shared by all tests, since the server's key takes time to create. */
  @TempDir private static Path folder;

  private OpcUaPlant plant;
  private OpcUaClient client;

  private String config() {
    return """
    [robots.cell1]
    host = "%s"
    port = %d
    timeout = "20s"

    [groups.all]
    variables = ["$OV_PRO"]
    period = "20ms"

    [variables."$OV_PRO"]
    range = [0, 100]
    write = true

    [opcua]
    address = "127.0.0.1:PORT"

    [opcua.users.anna]
    role = "operator"
    password-file = "anna.txt"
    """
        .formatted(robot.host(), robot.port());
  }

  @BeforeEach
  void start() throws Exception {
    Files.writeString(folder.resolve("anna.txt"), "of anna\n");
    plant = new OpcUaPlant(folder, config());
    client = plant.connect();
    awaitGood(client, "cell1:$OV_PRO");
  }

  @AfterEach
  void close() throws UaException {
    client.disconnect();
    plant.close();
  }

  @Test
  void aWriteThatWaitsWhenItsClientLogsOutIsNotSent() throws Exception {
    NodeId override = robots(client, "cell1:$OV_PRO");
    CountDownLatch arrived = new CountDownLatch(1);
    CountDownLatch released = new CountDownLatch(1);
    robot.fault(it -> isWriteOf(it, 11, arrived), Fault.hold(released));
    OpcUaClient leaving = plant.connect("anna", "of anna");
    OpcUaClient staying = plant.connect("anna", "of anna");
    try {
      var unusedSlow = leaving.writeAsync(List.of(writeOf(override, 11)));
      arrived.await();
      var unusedWaiting = leaving.writeAsync(List.of(writeOf(override, 12)));
      for (int i = 0; i < 20; i++) {
        // the server has begun the write by then
        read(leaving, override);
      }
      leaving.disconnect();
      released.countDown();

      assertThat(write(staying, override, 13)).isEqualTo(StatusCodes.Good);
    } finally {
      released.countDown();
      staying.disconnect();
    }
    assertThat(robot.requests())
        .filteredOn(RecordedRequest::isWrite)
        .extracting(it -> it.request().toString())
        .hasSize(2)
        .noneMatch(it -> it.contains("value=12"));
  }

  @Test
  void writesThatAClientSendsWithoutWaitingAreExecutedInOrder() throws Exception {
    NodeId override = robots(client, "cell1:$OV_PRO");
    OpcUaClient operator = plant.connect("anna", "of anna");
    List<String> sent = new ArrayList<>();
    try {
      for (int round = 0; round < 10; round++) {
        List<CompletableFuture<WriteResponse>> answers = new ArrayList<>();
        for (int i = 0; i < 10; i++) {
          int value = 10 * round + i;
          sent.add("value=" + value + "]");
          answers.add(operator.writeAsync(List.of(writeOf(override, value))));
        }
        for (CompletableFuture<WriteResponse> answer : answers) {
          assertThat(answer.join().getResults()).containsExactly(StatusCode.GOOD);
        }
      }
    } finally {
      operator.disconnect();
    }
    assertThat(robot.requests())
        .filteredOn(RecordedRequest::isWrite)
        .extracting(it -> it.request().toString().replaceAll(".*(?=value=)", ""))
        .containsExactlyElementsOf(sent);
  }

  @Test
  void aConnectionHasAtMost50UnansweredWritesToRobots() throws Exception {
    String cell1 = config().substring(0, config().indexOf("[groups"));
    plant.apply(cell1.replace("cell1", "cell2") + cell1.replace("cell1", "cell3") + config());
    List<String> overrides = List.of("cell1:$OV_PRO", "cell2:$OV_PRO", "cell3:$OV_PRO");
    for (String override : overrides) {
      awaitGood(client, override);
    }
    CountDownLatch released = new CountDownLatch(1);
    robot.fault(RecordedRequest::isWrite, Fault.hold(released));
    OpcUaClient operator = plant.connect("anna", "of anna");
    List<CompletableFuture<WriteResponse>> answers = new ArrayList<>();
    try {
      for (String override : overrides) {
        for (int i = 0; i < 17; i++) {
          answers.add(operator.writeAsync(List.of(writeOf(robots(client, override), i))));
        }
      }

      assertThatThrownBy(() -> answers.get(50).join())
          .hasCauseInstanceOf(UaException.class)
          .extracting(it -> ((UaException) it.getCause()).getStatusCode().value())
          .isEqualTo(StatusCodes.Bad_TooManyOperations);
      assertThat(answers.subList(0, 50)).noneMatch(CompletableFuture::isDone);

      released.countDown();
      for (CompletableFuture<WriteResponse> answer : answers.subList(0, 50)) {
        assertThat(answer.join().getResults()).containsExactly(StatusCode.GOOD);
      }
      assertThat(write(operator, robots(client, "cell3:$OV_PRO"), 50)).isEqualTo(StatusCodes.Good);
    } finally {
      released.countDown();
      operator.disconnect();
    }
  }

  private static boolean isWriteOf(RecordedRequest request, int value, CountDownLatch arrived) {
    boolean is = request.isWrite() && request.request().toString().contains("value=" + value);
    if (is) {
      arrived.countDown();
    }
    return is;
  }
}
