package no.hials.crosscom.gateway.internal.broker;

import io.prometheus.metrics.core.datapoints.CounterDataPoint;
import io.prometheus.metrics.core.datapoints.GaugeDataPoint;
import io.prometheus.metrics.core.metrics.Counter;
import java.util.List;
import no.hials.crosscom.gateway.Health;

/** The figures of one connection to a broker. */
final class SessionFigures {
  /**
   * The reasons why messages are lost. Each has a counter from the start, so that the first loss
   * shows as an increase.
   */
  private static final List<String> REASONS =
      List.of("damaged", "disk", "error", "full", "queue", "refused", "type", "unknown");

  private final String name;
  private final Counter dropped;
  final CounterDataPoint published;
  final CounterDataPoint stored;
  final CounterDataPoint damaged;
  final GaugeDataPoint connected;
  final GaugeDataPoint storedNow;
  final GaugeDataPoint storedBytes;

  SessionFigures(Health health, String name) {
    String label = "connection";
    this.name = name;
    dropped =
        health.counter(
            "mqtt_messages_dropped", "Messages that were lost, by the reason", label, "reason");
    REASONS.forEach(reason -> dropped.initLabelValues(name, reason));
    published =
        health
            .counter("mqtt_messages_published", "Messages that the broker has taken", label)
            .labelValues(name);
    stored =
        health
            .counter("mqtt_messages_stored", "Messages that went to the store on disk", label)
            .labelValues(name);
    damaged =
        health
            .counter(
                "mqtt_store_damaged", "Files of the store with a part that is unreadable", label)
            .labelValues(name);
    connected =
        health.gauge("mqtt_connected", "Whether the broker is connected", label).labelValues(name);
    storedNow =
        health
            .gauge("mqtt_store_messages", "Messages that wait in the store", label)
            .labelValues(name);
    storedBytes =
        health.gauge("mqtt_store_bytes", "Size of the store on disk", label).labelValues(name);
  }

  /** Counts lost messages. */
  void dropped(String reason, long messages) {
    if (messages > 0) {
      dropped.labelValues(name, reason).inc(messages);
    }
  }
}
