package no.hials.crosscom.gateway;

import static no.hials.crosscom.gateway.OpcUaPlant.robots;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.Unsigned.ubyte;
import static org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.Unsigned.uint;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.eclipse.milo.opcua.sdk.client.OpcUaClient;
import org.eclipse.milo.opcua.stack.core.AttributeId;
import org.eclipse.milo.opcua.stack.core.NodeIds;
import org.eclipse.milo.opcua.stack.core.StatusCodes;
import org.eclipse.milo.opcua.stack.core.UaException;
import org.eclipse.milo.opcua.stack.core.types.builtin.NodeId;
import org.eclipse.milo.opcua.stack.core.types.builtin.QualifiedName;
import org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.UInteger;
import org.eclipse.milo.opcua.stack.core.types.enumerated.MonitoringMode;
import org.eclipse.milo.opcua.stack.core.types.enumerated.TimestampsToReturn;
import org.eclipse.milo.opcua.stack.core.types.structured.CloseSessionRequest;
import org.eclipse.milo.opcua.stack.core.types.structured.CreateSubscriptionResponse;
import org.eclipse.milo.opcua.stack.core.types.structured.MonitoredItemCreateRequest;
import org.eclipse.milo.opcua.stack.core.types.structured.MonitoredItemCreateResult;
import org.eclipse.milo.opcua.stack.core.types.structured.MonitoringParameters;
import org.eclipse.milo.opcua.stack.core.types.structured.PublishResponse;
import org.eclipse.milo.opcua.stack.core.types.structured.ReadValueId;
import org.junit.jupiter.api.Test;

/** The limits for clients that ask for much, or that do not come back. */
class OpcUaSubscriptionsTest extends OpcUaServerTest {
  @Override
  String config() {
    return cell1()
        + """

    [groups.all]
    variables = ["$OV_PRO"]
    period = "20ms"

    [opcua]
    address = "127.0.0.1:PORT"
    """;
  }

  private CreateSubscriptionResponse createSubscription(double interval) throws UaException {
    return client.createSubscription(interval, uint(10_000), uint(1000), uint(0), true, ubyte(0));
  }

  private List<MonitoredItemCreateResult> watch(UInteger subscription, NodeId id, int count)
      throws UaException {
    MonitoredItemCreateRequest item =
        new MonitoredItemCreateRequest(
            new ReadValueId(id, AttributeId.Value.uid(), null, QualifiedName.NULL_VALUE),
            MonitoringMode.Reporting,
            new MonitoringParameters(uint(1), 0.0, null, uint(65_535), true));
    return List.of(
        client
            .createMonitoredItems(
                subscription, TimestampsToReturn.Both, Collections.nCopies(count, item))
            .getResults());
  }

  private static List<Long> queues(List<MonitoredItemCreateResult> items) {
    return items.stream().map(it -> it.getRevisedQueueSize().longValue()).toList();
  }

  @Test
  void theItemsOfASessionAndTheirQueuesAreLimited() throws Exception {
    UInteger subscription = createSubscription(1000).getSubscriptionId();
    List<MonitoredItemCreateResult> items = new ArrayList<>();
    while (items.size() < 20_000) {
      items.addAll(watch(subscription, robots(client, "cell1:$OV_PRO"), 2000));
      items.addAll(watch(subscription, NodeIds.Server_ServerStatus_CurrentTime, 2000));
    }

    assertThat(items).hasSize(20_000).allMatch(it -> it.getStatusCode().isGood());
    assertThat(queues(items)).startsWith(1000L).endsWith(5L);
    assertThat(queues(items).stream().mapToLong(it -> it).sum()).isLessThan(650_000);
    assertThat(watch(subscription, NodeIds.Server_ServerStatus_CurrentTime, 1))
        .extracting(it -> it.getStatusCode().value())
        .containsExactly(StatusCodes.Bad_TooManyMonitoredItems);
  }

  @Test
  void theSubscriptionsOfASessionAndTheirLifetimesAreLimited() throws Exception {
    CreateSubscriptionResponse revised = createSubscription(600_000);
    for (int i = 1; i < 50; i++) {
      createSubscription(1000);
    }

    assertThat(
            revised.getRevisedPublishingInterval() * revised.getRevisedLifetimeCount().intValue())
        .isEqualTo(60_000);
    assertThatThrownBy(() -> createSubscription(1000))
        .isInstanceOfSatisfying(
            UaException.class,
            it ->
                assertThat(it.getStatusCode().value())
                    .isEqualTo(StatusCodes.Bad_TooManySubscriptions));
  }

  @Test
  void subscriptionsEndWithTheirSession() throws Exception {
    OpcUaClient other = client;
    UInteger left = createSubscription(1000).getSubscriptionId();
    watch(left, robots(client, "cell1:$OV_PRO"), 1000);
    client
        .getTransport()
        .sendRequestMessage(
            new CloseSessionRequest(
                client.newRequestHeader(client.getSession().getAuthenticationToken()), false))
        .get();
    var unused = other.disconnectAsync();

    client = plant.connect();
    long queue;
    do {
      // an item has a shorter queue while there are others
      UInteger own = createSubscription(1000).getSubscriptionId();
      queue = queues(watch(own, robots(client, "cell1:$OV_PRO"), 1)).get(0);
      client.deleteSubscriptions(List.of(own));
    } while (queue < 1000);
  }

  @Test
  void messagesThatAClientDoesNotAcknowledgeAreDeleted() throws Exception {
    UInteger subscription = createSubscription(10).getSubscriptionId();
    watch(subscription, robots(client, "cell1:$OV_PRO"), 1);

    PublishResponse response;
    int value = 0;
    do {
      robot.variables().set("$OV_PRO", String.valueOf(value++ % 100));
      response = client.publish(List.of());
    } while (response.getAvailableSequenceNumbers()[0].equals(uint(1)));

    assertThat(response.getNotificationMessage().getSequenceNumber().longValue())
        .as("the number of messages")
        .isLessThan(1000);
  }
}
