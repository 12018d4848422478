package no.hials.crosscom.gateway.internal.opcua;

import java.util.List;
import org.eclipse.milo.opcua.sdk.server.AccessContext;
import org.eclipse.milo.opcua.sdk.server.AttributeReader;
import org.eclipse.milo.opcua.sdk.server.ManagedNamespaceWithLifecycle;
import org.eclipse.milo.opcua.sdk.server.OpcUaServer;
import org.eclipse.milo.opcua.sdk.server.items.DataItem;
import org.eclipse.milo.opcua.sdk.server.items.MonitoredItem;
import org.eclipse.milo.opcua.stack.core.StatusCodes;
import org.eclipse.milo.opcua.stack.core.types.builtin.DataValue;
import org.eclipse.milo.opcua.stack.core.types.builtin.QualifiedName;
import org.eclipse.milo.opcua.stack.core.types.enumerated.TimestampsToReturn;
import org.eclipse.milo.opcua.stack.core.types.structured.ReadValueId;

/** A namespace whose attributes do not change: a client that watches one gets its value once. */
class StaticNamespace extends ManagedNamespaceWithLifecycle {
  StaticNamespace(OpcUaServer server, String uri) {
    super(server, uri);
  }

  @Override
  public void onDataItemsCreated(List<DataItem> items) {
    for (DataItem item : items) {
      item.setValue(read(item.getReadValueId()));
    }
  }

  private DataValue read(ReadValueId what) {
    return getNodeManager()
        .getNode(what.getNodeId())
        .map(
            node ->
                AttributeReader.readAttribute(
                    AccessContext.INTERNAL,
                    node,
                    what.getAttributeId(),
                    TimestampsToReturn.Both,
                    what.getIndexRange(),
                    what.getDataEncoding() == null
                        ? QualifiedName.NULL_VALUE
                        : what.getDataEncoding()))
        .orElseGet(() -> new DataValue(StatusCodes.Bad_NodeIdUnknown));
  }

  @Override
  public void onDataItemsModified(List<DataItem> items) {
    // the values do not change
  }

  @Override
  public void onDataItemsDeleted(List<DataItem> items) {
    // no item is kept
  }

  @Override
  public void onMonitoringModeChanged(List<MonitoredItem> items) {
    // the item itself holds back its values
  }
}
