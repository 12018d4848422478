package no.hials.crosscom.gateway;

import static org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.Unsigned.uint;

import java.io.IOException;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Consumer;
import java.util.function.Predicate;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.gateway.internal.opcua.OpcUaKind;
import org.eclipse.milo.opcua.sdk.client.OpcUaClient;
import org.eclipse.milo.opcua.sdk.client.OpcUaClientConfigBuilder;
import org.eclipse.milo.opcua.sdk.client.identity.UsernameProvider;
import org.eclipse.milo.opcua.sdk.client.subscriptions.OpcUaMonitoredItem;
import org.eclipse.milo.opcua.sdk.client.subscriptions.OpcUaSubscription;
import org.eclipse.milo.opcua.stack.core.AttributeId;
import org.eclipse.milo.opcua.stack.core.NodeIds;
import org.eclipse.milo.opcua.stack.core.UaException;
import org.eclipse.milo.opcua.stack.core.security.SecurityPolicy;
import org.eclipse.milo.opcua.stack.core.types.builtin.DataValue;
import org.eclipse.milo.opcua.stack.core.types.builtin.NodeId;
import org.eclipse.milo.opcua.stack.core.types.builtin.Variant;
import org.eclipse.milo.opcua.stack.core.types.enumerated.BrowseDirection;
import org.eclipse.milo.opcua.stack.core.types.enumerated.BrowseResultMask;
import org.eclipse.milo.opcua.stack.core.types.enumerated.NodeClass;
import org.eclipse.milo.opcua.stack.core.types.enumerated.TimestampsToReturn;
import org.eclipse.milo.opcua.stack.core.types.structured.BrowseDescription;
import org.eclipse.milo.opcua.stack.core.types.structured.ReadValueId;
import org.eclipse.milo.opcua.stack.core.types.structured.ReferenceDescription;
import org.eclipse.milo.opcua.stack.core.types.structured.WriteValue;
import org.eclipse.milo.opcua.stack.transport.client.tcp.OpcTcpClientTransportConfigBuilder;

/** A gateway with an OPC UA server, and Milo's client for it. */
final class OpcUaPlant implements AutoCloseable {
  static final String ROBOTS = "urn:jopenshowvar:gateway:robots";
  static final String ROBOTICS = "http://opcfoundation.org/UA/Robotics/";
  static final String DI = "http://opcfoundation.org/UA/DI/";

  private static final List<OutputKind<?>> KINDS = List.of(new OpcUaKind());

  private final int port = freePort();
  private final Path folder;
  private final Gateway gateway;

  /**
   * Starts a gateway.
   *
   * @param text the configuration, with {@code PORT} in place of the server's port
   */
  OpcUaPlant(Path folder, String text) throws IOException {
    this.folder = folder;
    gateway = Gateway.start(read(text), KINDS, RobotConnection::openLazily);
  }

  private static int freePort() {
    try (ServerSocket socket = new ServerSocket(0)) {
      return socket.getLocalPort();
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  private GatewayConfig read(String text) throws IOException {
    TomlTable root =
        TomlTable.parse(folder.resolve("plant.toml"), text.replace("PORT", String.valueOf(port)));
    return GatewayConfig.read(root, folder, Map.of(), KINDS);
  }

  /** Applies another configuration. */
  void apply(String text) throws IOException {
    gateway.apply(read(text));
  }

  Health health() {
    return gateway.health();
  }

  String url() {
    return "opc.tcp://127.0.0.1:" + port;
  }

  OpcUaClient connect() throws UaException {
    return connect(SecurityPolicy.None, config -> {});
  }

  OpcUaClient connect(String user, String password) throws UaException {
    return connect(
        SecurityPolicy.None,
        config -> config.setIdentityProvider(new UsernameProvider(user, password)));
  }

  OpcUaClient connect(SecurityPolicy policy, Consumer<OpcUaClientConfigBuilder> settings)
      throws UaException {
    OpcUaClient client =
        OpcUaClient.create(
            url(),
            endpoints ->
                endpoints.stream()
                    .filter(it -> it.getSecurityPolicyUri().equals(policy.getUri()))
                    .findFirst(),
            (OpcTcpClientTransportConfigBuilder transport) -> {},
            config -> {
              config.setRequestTimeout(uint(20_000));
              settings.accept(config);
            });
    try {
      return client.connect();
    } catch (UaException e) {
      var unused = client.disconnectAsync();
      throw e;
    }
  }

  /** Returns an id by the URI of its namespace. */
  static NodeId id(OpcUaClient client, String namespace, Object identifier) {
    int index = client.getNamespaceTable().getIndex(namespace).intValue();
    return identifier instanceof Integer number
        ? new NodeId(index, number)
        : new NodeId(index, (String) identifier);
  }

  static NodeId robots(OpcUaClient client, String identifier) {
    return id(client, ROBOTS, identifier);
  }

  static DataValue read(OpcUaClient client, NodeId id) throws UaException {
    return read(client, id, AttributeId.Value);
  }

  static DataValue read(OpcUaClient client, NodeId id, AttributeId attribute) throws UaException {
    return read(client, List.of(id), attribute).get(0);
  }

  static List<DataValue> read(OpcUaClient client, List<NodeId> ids, AttributeId attribute)
      throws UaException {
    List<ReadValueId> all =
        ids.stream().map(id -> new ReadValueId(id, attribute.uid(), null, null)).toList();
    return List.of(client.read(0, TimestampsToReturn.Both, all).getResults());
  }

  /** Reads until a value is as expected; the test's timeout is the deadline. */
  static DataValue await(OpcUaClient client, NodeId id, Predicate<DataValue> condition)
      throws UaException {
    DataValue value;
    do {
      value = read(client, id);
    } while (!condition.test(value));
    return value;
  }

  static DataValue awaitGood(OpcUaClient client, String variable) throws UaException {
    return await(client, robots(client, variable), value -> value.statusCode().isGood());
  }

  /** Writes a value, and returns the code of its status. */
  static long write(OpcUaClient client, NodeId id, Object value) throws UaException {
    return client.write(List.of(writeOf(id, value))).getResults()[0].value();
  }

  static WriteValue writeOf(NodeId id, Object value) {
    return new WriteValue(
        id, AttributeId.Value.uid(), null, DataValue.valueOnly(new Variant(value)));
  }

  private static List<ReferenceDescription> children(OpcUaClient client, NodeId id)
      throws UaException {
    BrowseDescription all =
        new BrowseDescription(
            id,
            BrowseDirection.Forward,
            NodeIds.HierarchicalReferences,
            true,
            uint(0),
            uint(BrowseResultMask.All.getValue()));
    ReferenceDescription[] found = client.browse(all).getReferences();
    return List.of(Optional.ofNullable(found).orElse(new ReferenceDescription[0]));
  }

  /** Returns the variables of namespace 0. */
  static List<NodeId> standardVariables(OpcUaClient client) throws UaException {
    List<NodeId> variables = new ArrayList<>();
    Set<NodeId> seen = new HashSet<>();
    Deque<NodeId> next = new ArrayDeque<>(List.of(NodeIds.RootFolder));
    while (!next.isEmpty()) {
      for (ReferenceDescription child : children(client, next.remove())) {
        NodeId id = child.getNodeId().toNodeId(client.getNamespaceTable()).orElseThrow();
        if (id.getNamespaceIndex().intValue() == 0 && seen.add(id)) {
          next.add(id);
          if (child.getNodeClass() == NodeClass.Variable) {
            variables.add(id);
          }
        }
      }
    }
    return variables;
  }

  /** Returns the objects and variables of a node that have a type. */
  static List<ReferenceDescription> children(OpcUaClient client, NodeId id, NodeId type)
      throws UaException {
    return children(client, id).stream()
        .filter(
            it ->
                it.getTypeDefinition()
                    .toNodeId(client.getNamespaceTable())
                    .filter(type::equals)
                    .isPresent())
        .toList();
  }

  /** Subscribes to a node, and returns the queue of its values. */
  static BlockingQueue<DataValue> subscribe(OpcUaClient client, NodeId id) throws UaException {
    BlockingQueue<DataValue> values = new LinkedBlockingQueue<>();
    OpcUaMonitoredItem item =
        new OpcUaMonitoredItem(new ReadValueId(id, AttributeId.Value.uid(), null, null));
    item.setSamplingInterval(0);
    item.setQueueSize(uint(100));
    item.setDataValueListener((it, value) -> values.add(value));
    OpcUaSubscription subscription = new OpcUaSubscription(client, 20);
    subscription.create();
    subscription.addMonitoredItem(item);
    subscription.createMonitoredItems();
    return values;
  }

  /** Waits for a value of a subscription. */
  static DataValue await(BlockingQueue<DataValue> values, Predicate<DataValue> condition)
      throws InterruptedException {
    DataValue value;
    do {
      value = values.take();
    } while (!condition.test(value));
    return value;
  }

  @Override
  public void close() {
    gateway.close();
  }
}
