package no.hials.crosscom.gateway.internal.opcua;

import static org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.Unsigned.uint;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.gateway.Lasting;
import org.eclipse.milo.opcua.sdk.server.AddressSpaceFilter;
import org.eclipse.milo.opcua.sdk.server.ManagedAddressSpaceFragment;
import org.eclipse.milo.opcua.sdk.server.OpcUaServer;
import org.eclipse.milo.opcua.sdk.server.OpcUaServerConfigLimits;
import org.eclipse.milo.opcua.sdk.server.Session;
import org.eclipse.milo.opcua.sdk.server.SimpleAddressSpaceFilter;
import org.eclipse.milo.opcua.sdk.server.items.DataItem;
import org.eclipse.milo.opcua.sdk.server.items.EventItem;
import org.eclipse.milo.opcua.sdk.server.items.MonitoredItem;
import org.eclipse.milo.opcua.sdk.server.subscriptions.Subscription;
import org.eclipse.milo.opcua.sdk.server.subscriptions.SubscriptionDeletedEvent;
import org.eclipse.milo.opcua.stack.core.types.builtin.NodeId;
import org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.UInteger;
import org.eclipse.milo.opcua.stack.core.types.structured.ReadValueId;

/**
 * Limits what the subscriptions of clients keep in memory. It has no nodes: the server asks it for
 * the queues of all monitored items, including those of Milo's own nodes.
 */
final class Subscriptions extends ManagedAddressSpaceFragment {
  /** The unacknowledged messages that a subscription keeps for a client that asks again. */
  private static final int MAX_UNACKNOWLEDGED = 20;

  private static final long MAX_QUEUE = 1000;

  /** With N items, a new queue has at most this number divided by N values. */
  private static final long SHARED_QUEUE = 100_000;

  private final ScheduledFuture<?> trimming;

  /** The numbers and times that the server itself checks. */
  static final class Limits implements OpcUaServerConfigLimits {
    @Override
    public Double getMaxPublishingInterval() {
      // Milo makes a lifetime at least three times as long
      return 20_000.0;
    }

    @Override
    public Double getMaxSubscriptionLifetime() {
      return 60_000.0;
    }

    @Override
    public UInteger getMaxSubscriptionsPerSession() {
      return uint(50);
    }

    @Override
    public UInteger getMaxSubscriptions() {
      return uint(500);
    }

    @Override
    public UInteger getMaxMonitoredItemsPerSession() {
      return uint(20_000);
    }

    @Override
    public UInteger getMaxNodesPerWrite() {
      // robots take 5 s for them, and a write does not wait longer
      return uint(1000);
    }

    @Override
    public UInteger getMaxMonitoredItems() {
      return uint(50_000);
    }
  }

  /** Chooses the questions for the parameters of a monitored item. */
  private static final class Parameters extends SimpleAddressSpaceFilter {
    @Override
    protected boolean filterNode(NodeId id) {
      return false;
    }

    @Override
    protected boolean filterMonitoredItem(NodeId id) {
      return false;
    }

    @Override
    public boolean filterOnCreateDataItem(OpcUaServer server, ReadValueId what) {
      return true;
    }

    @Override
    public boolean filterOnModifyDataItem(OpcUaServer server, ReadValueId what) {
      return true;
    }

    @Override
    public boolean filterOnCreateEventItem(OpcUaServer server, ReadValueId what) {
      return true;
    }

    @Override
    public boolean filterOnModifyEventItem(OpcUaServer server, ReadValueId what) {
      return true;
    }
  }

  private final AddressSpaceFilter filter = new Parameters();

  Subscriptions(OpcUaServer server) {
    super(server);
    server.getAddressSpaceManager().registerFirst(this);
    trimming =
        server
            .getScheduledExecutorService()
            .scheduleWithFixedDelay(
                Lasting.task(() -> server.getSubscriptions().values().forEach(Subscriptions::trim)),
                1,
                1,
                TimeUnit.SECONDS);
  }

  /** Deletes old messages that a client has not acknowledged: Milo keeps 1,024. */
  private static void trim(Subscription subscription) {
    UInteger[] waiting = subscription.getAvailableSequenceNumbers();
    Arrays.stream(waiting)
        .limit(Math.max(0, waiting.length - MAX_UNACKNOWLEDGED))
        .forEach(subscription::acknowledge);
  }

  /**
   * Ends the subscriptions of a session that has ended. Milo leaves them to be transferred, and
   * then does not release their monitored items at the end of their lifetime.
   */
  void end(Session session) {
    OpcUaServer server = getServer();
    for (Subscription subscription : server.getSubscriptions().values()) {
      // Milo transfers a subscription to another session under this lock
      synchronized (subscription) {
        if (subscription.getSession().equals(session)
            && server.getSubscriptions().remove(subscription.getId()) != null) {
          server.getInternalEventBus().post(new SubscriptionDeletedEvent(subscription));
          release(subscription.deleteSubscription());
        }
      }
    }
  }

  private void release(List<? extends MonitoredItem> items) {
    List<DataItem> data = new ArrayList<>();
    List<EventItem> events = new ArrayList<>();
    for (MonitoredItem item : items) {
      if (item instanceof DataItem one) {
        data.add(one);
      } else if (item instanceof EventItem one) {
        events.add(one);
      }
    }
    getServer().getAddressSpaceManager().onDataItemsDeleted(data);
    getServer().getAddressSpaceManager().onEventItemsDeleted(events);
    getServer().getMonitoredItemCount().addAndGet(-items.size());
  }

  void shutdown() {
    trimming.cancel(false);
    getServer().getAddressSpaceManager().unregister(this);
  }

  @Override
  public AddressSpaceFilter getFilter() {
    return filter;
  }

  @Override
  public RevisedDataItemParameters onCreateDataItem(
      ReadValueId what, Double samplingInterval, UInteger queueSize) {
    return revised(what, samplingInterval, queueSize);
  }

  @Override
  public RevisedDataItemParameters onModifyDataItem(
      ReadValueId what, Double samplingInterval, UInteger queueSize) {
    return revised(what, samplingInterval, queueSize);
  }

  @Override
  public RevisedEventItemParameters onCreateEventItem(ReadValueId what, UInteger queueSize) {
    return new RevisedEventItemParameters(queue(queueSize));
  }

  @Override
  public RevisedEventItemParameters onModifyEventItem(ReadValueId what, UInteger queueSize) {
    return new RevisedEventItemParameters(queue(queueSize));
  }

  private RevisedDataItemParameters revised(
      ReadValueId what, Double samplingInterval, UInteger queueSize) {
    // an item of a robot gets each value that the plan reads
    boolean ofRobot =
        RobotsNamespace.URI.equals(
            getServer().getNamespaceTable().get(what.getNodeId().getNamespaceIndex()));
    return new RevisedDataItemParameters(ofRobot ? 0.0 : samplingInterval, queue(queueSize));
  }

  /** Returns a smaller queue the more items there are, so that all queues together are bounded. */
  private UInteger queue(UInteger requested) {
    long items = Math.max(1, getServer().getMonitoredItemCount().get());
    long longest = Math.max(1, Math.min(MAX_QUEUE, SHARED_QUEUE / items));
    return uint(Math.min(requested.longValue(), longest));
  }

  @Override
  public void onDataItemsCreated(List<DataItem> items) {
    // the namespace of the node is called
  }

  @Override
  public void onDataItemsModified(List<DataItem> items) {
    // the namespace of the node is called
  }

  @Override
  public void onDataItemsDeleted(List<DataItem> items) {
    // the namespace of the node is called
  }

  @Override
  public void onMonitoringModeChanged(List<MonitoredItem> items) {
    // the namespace of the node is called
  }
}
