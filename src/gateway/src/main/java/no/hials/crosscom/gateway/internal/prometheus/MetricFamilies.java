package no.hials.crosscom.gateway.internal.prometheus;

import io.prometheus.metrics.model.snapshots.CounterSnapshot;
import io.prometheus.metrics.model.snapshots.GaugeSnapshot;
import io.prometheus.metrics.model.snapshots.Labels;
import io.prometheus.metrics.model.snapshots.MetricSnapshots;
import java.util.LinkedHashMap;
import java.util.Map;

/** Collects the series of all robots by the names of their metrics. */
final class MetricFamilies {
  private static final String PREFIX = "jopenshowvar_";

  private final Map<String, GaugeSnapshot.Builder> gauges = new LinkedHashMap<>();
  private final Map<String, CounterSnapshot.Builder> counters = new LinkedHashMap<>();

  /** Adds a value that goes up and down. */
  void gauge(String name, String help, Labels labels, double value) {
    gauges
        .computeIfAbsent(name, it -> GaugeSnapshot.builder().name(PREFIX + it).help(help))
        .dataPoint(
            GaugeSnapshot.GaugeDataPointSnapshot.builder().labels(labels).value(value).build());
  }

  /** Adds a value that only goes up. */
  void counter(String name, String help, Labels labels, long value) {
    counters
        .computeIfAbsent(name, it -> CounterSnapshot.builder().name(PREFIX + it).help(help))
        .dataPoint(
            CounterSnapshot.CounterDataPointSnapshot.builder()
                .labels(labels)
                .value((double) value)
                .build());
  }

  MetricSnapshots snapshots() {
    MetricSnapshots.Builder all = MetricSnapshots.builder();
    gauges.values().forEach(one -> all.metricSnapshot(one.build()));
    counters.values().forEach(one -> all.metricSnapshot(one.build()));
    return all.build();
  }
}
