package no.hials.crosscom.gateway;

import static no.hials.crosscom.gateway.OpcUaPlant.awaitGood;
import static no.hials.crosscom.gateway.OpcUaPlant.read;
import static no.hials.crosscom.gateway.OpcUaPlant.robots;
import static no.hials.crosscom.gateway.OpcUaPlant.write;
import static no.hials.crosscom.gateway.OpcUaPlant.writeOf;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.RecordedRequest;
import org.eclipse.milo.opcua.sdk.client.OpcUaClient;
import org.eclipse.milo.opcua.stack.core.StatusCodes;
import org.eclipse.milo.opcua.stack.core.UaException;
import org.eclipse.milo.opcua.stack.core.types.builtin.NodeId;
import org.eclipse.milo.opcua.stack.core.types.builtin.StatusCode;
import org.eclipse.milo.opcua.stack.core.types.structured.WriteResponse;
import org.eclipse.milo.opcua.stack.core.types.structured.WriteValue;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Writes that a client sends before the earlier ones are answered. */
class OpcUaWritesTest extends OpcUaServerTest {
  @Override
  String config() {
    return cell1()
        + """
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
    """;
  }

  @BeforeEach
  void awaitFirstReading() throws Exception {
    awaitGood(client, "cell1:$OV_PRO");
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

  /** Writes a value, with text that makes the request that much larger. */
  private CompletableFuture<Object> writeAsync(OpcUaClient from, int value, int size) {
    NodeId override = robots(from, "cell1:$OV_PRO");
    NodeId large = robots(from, "cell1:" + "x".repeat(size));
    return from.writeAsync(List.of(writeOf(override, value), writeOf(large, 0)))
        .handle(
            (response, failure) ->
                failure == null
                    ? response.getResults()[0]
                    : ((UaException) failure.getCause()).getStatusCode());
  }

  @Test
  void theSizeOfWritesThatWaitIsLimited() throws Exception {
    StatusCode tooMany = new StatusCode(StatusCodes.Bad_TooManyOperations);
    CountDownLatch released = new CountDownLatch(1);
    robot.fault(RecordedRequest::isWrite, Fault.hold(released));
    List<OpcUaClient> clients = new ArrayList<>();
    List<CompletableFuture<Object>> accepted = new ArrayList<>();
    try {
      while (clients.size() < 11) {
        clients.add(plant.connect("anna", "of anna"));
      }
      for (OpcUaClient each : clients) {
        accepted.add(writeAsync(each, 10, 1));
      }
      assertThat(writeAsync(clients.get(0), 50, 100_000).join())
          .isEqualTo(new StatusCode(StatusCodes.Bad_RequestTooLarge));
      for (OpcUaClient each : clients.subList(0, 10)) {
        accepted.add(writeAsync(each, 20, 95_000));
        assertThat(writeAsync(each, 51, 10_000).join()).as("105,000 of 100,000").isEqualTo(tooMany);
      }
      assertThat(writeAsync(clients.get(10), 52, 95_000).join())
          .as("1,045,000 of 1,000,000")
          .isEqualTo(tooMany);
      assertThat(accepted).noneMatch(CompletableFuture::isDone);

      released.countDown();
      for (CompletableFuture<Object> answer : accepted) {
        assertThat(answer.join()).isEqualTo(StatusCode.GOOD);
      }
      assertThat(writeAsync(clients.get(10), 21, 95_000).join()).isEqualTo(StatusCode.GOOD);
    } finally {
      released.countDown();
      for (OpcUaClient each : clients) {
        each.disconnect();
      }
    }
    assertThat(robot.requests())
        .filteredOn(RecordedRequest::isWrite)
        .extracting(it -> it.request().toString())
        .hasSize(22)
        .noneMatch(it -> it.matches(".*value=5\\d.*"));
  }

  @Test
  void requestsWithManyValuesOrLargeArraysAreRefused() throws Exception {
    NodeId override = robots(client, "cell1:$OV_PRO");
    OpcUaClient operator = plant.connect("anna", "of anna");
    try {
      assertThat(statusOf(operator, Collections.nCopies(1001, writeOf(override, 1))))
          .isEqualTo(StatusCodes.Bad_TooManyOperations);
      assertThat(statusOf(operator, List.of(writeOf(override, new Byte[6000]))))
          .isEqualTo(StatusCodes.Bad_RequestTooLarge);
      assertThat(write(operator, override, new Integer[] {1}))
          .isEqualTo(StatusCodes.Bad_TypeMismatch);
      assertThat(write(operator, override, 2)).isEqualTo(StatusCodes.Good);
    } finally {
      operator.disconnect();
    }
  }

  private static long statusOf(OpcUaClient from, List<WriteValue> values) {
    try {
      return from.write(values).getResponseHeader().getServiceResult().value();
    } catch (UaException e) {
      return e.getStatusCode().value();
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
