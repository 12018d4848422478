package no.hials.crosscom.gateway.internal.opcua;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.eclipse.milo.opcua.sdk.core.Reference;
import org.eclipse.milo.opcua.sdk.server.OpcUaServer;
import org.eclipse.milo.opcua.sdk.server.Session;
import org.eclipse.milo.opcua.sdk.server.items.DataItem;
import org.eclipse.milo.opcua.sdk.server.nodes.UaNode;
import org.eclipse.milo.opcua.stack.core.AttributeId;
import org.eclipse.milo.opcua.stack.core.StatusCodes;
import org.eclipse.milo.opcua.stack.core.encoding.EncodingContext;
import org.eclipse.milo.opcua.stack.core.types.builtin.DataValue;
import org.eclipse.milo.opcua.stack.core.types.builtin.NodeId;
import org.eclipse.milo.opcua.stack.core.types.builtin.QualifiedName;
import org.eclipse.milo.opcua.stack.core.types.builtin.StatusCode;
import org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.UInteger;
import org.eclipse.milo.opcua.stack.core.types.structured.ReadValueId;
import org.eclipse.milo.opcua.stack.core.types.structured.WriteValue;
import org.jspecify.annotations.Nullable;

/**
 * The nodes of all robots. It keeps what clients watch by node id, so that they get values again
 * when a robot is removed and added again.
 */
final class RobotsNamespace extends StaticNamespace {
  static final String URI = "urn:jopenshowvar:gateway:robots";
  private static final UInteger VALUE = AttributeId.Value.uid();

  private final CompanionTypes types;
  private final RobotWrites writes;
  private final WriteOrder order;
  private final Map<NodeId, Set<DataItem>> items = new ConcurrentHashMap<>();

  RobotsNamespace(OpcUaServer server, CompanionTypes types, RobotWrites writes, WriteOrder order) {
    super(server, URI);
    this.types = types;
    this.writes = writes;
    this.order = order;
  }

  CompanionTypes types() {
    return types;
  }

  NodeId id(String text) {
    return newNodeId(text);
  }

  QualifiedName name(String text) {
    return newQualifiedName(text);
  }

  EncodingContext encoding() {
    return getServer().getStaticEncodingContext();
  }

  @Nullable UaNode node(NodeId id) {
    return getNodeManager().getNode(id).orElse(null);
  }

  void add(UaNode node) {
    getNodeManager().addNode(node);
    if (node instanceof ValueNode value) {
      items.getOrDefault(node.getNodeId(), Set.of()).forEach(value::watch);
    }
  }

  /** Removes a node and its references, and notifies the clients that watch it. */
  void remove(UaNode node) {
    for (Reference reference : node.getReferences()) {
      getNodeManager().removeReferences(reference, getServer().getNamespaceTable());
    }
    getNodeManager().removeNode(node.getNodeId());
    getNodeManager().getReferenceMap().remove(node.getNodeId());
    if (node instanceof ValueNode value) {
      for (DataItem item : items.getOrDefault(node.getNodeId(), Set.of())) {
        value.forget(item);
        item.setValue(new DataValue(StatusCodes.Bad_NodeIdUnknown));
      }
    }
  }

  @Override
  public void onDataItemsCreated(List<DataItem> created) {
    List<DataItem> others = new ArrayList<>();
    for (DataItem item : created) {
      ReadValueId what = item.getReadValueId();
      if (what.getAttributeId().equals(VALUE) && isWhole(what.getIndexRange())) {
        items.computeIfAbsent(what.getNodeId(), it -> ConcurrentHashMap.newKeySet()).add(item);
        if (node(what.getNodeId()) instanceof ValueNode node) {
          node.watch(item);
          continue;
        }
      }
      others.add(item);
    }
    super.onDataItemsCreated(others);
  }

  private static boolean isWhole(@Nullable String indexRange) {
    return indexRange == null || indexRange.isEmpty();
  }

  @Override
  public void onDataItemsDeleted(List<DataItem> deleted) {
    for (DataItem item : deleted) {
      NodeId id = item.getReadValueId().getNodeId();
      items.computeIfPresent(
          id,
          (key, its) -> {
            its.remove(item);
            return its.isEmpty() ? null : its;
          });
      if (node(id) instanceof ValueNode node) {
        node.forget(item);
      }
    }
  }

  @Override
  public List<StatusCode> write(WriteContext context, List<WriteValue> values) {
    Session session = context.getSession().orElse(null);
    User user = session == null ? User.ANONYMOUS : Users.of(session);
    RobotWrites.Request request =
        RobotWrites.request(
            order.arrival(),
            user,
            Duration.ofMillis(context.getTimeoutHint().longValue()),
            () -> session != null && exists(session));
    List<StatusCode> results = new ArrayList<>();
    for (WriteValue value : values) {
      results.add(new StatusCode(write(request, user, value)));
    }
    return results;
  }

  private boolean exists(Session session) {
    return getServer().getSessionManager().getAllSessions().contains(session);
  }

  private long write(RobotWrites.Request request, User user, WriteValue write) {
    UaNode node = node(write.getNodeId());
    if (node == null) {
      return StatusCodes.Bad_NodeIdUnknown;
    }
    if (!write.getAttributeId().equals(VALUE)
        || !(node instanceof ValueNode variable)
        || !variable.isWritable()) {
      return StatusCodes.Bad_NotWritable;
    }
    if (user.role() != User.Role.OPERATOR) {
      return StatusCodes.Bad_UserAccessDenied;
    }
    if (!isWhole(write.getIndexRange())) {
      return StatusCodes.Bad_WriteNotSupported;
    }
    return writes.write(request, variable, write.getValue().value().value());
  }
}
