package no.hials.crosscom.gateway.internal.prometheus;

import io.prometheus.metrics.model.snapshots.ClassicHistogramBuckets;
import io.prometheus.metrics.model.snapshots.CounterSnapshot;
import io.prometheus.metrics.model.snapshots.GaugeSnapshot;
import io.prometheus.metrics.model.snapshots.HistogramSnapshot;
import io.prometheus.metrics.model.snapshots.Labels;
import io.prometheus.metrics.model.snapshots.MetricSnapshots;
import java.util.LinkedHashMap;
import java.util.Map;
import no.hials.crosscom.ClientStatistics;

/** Collects the series of all robots by the names of their metrics. */
final class MetricFamilies {
  private static final String PREFIX = "jopenshowvar_";

  /**
   * The upper bounds of the buckets in s: powers of two in ns as in the client, 0.5 ms to 4.3 s.
   */
  private static final double[] BOUNDS = bounds(19, 32);

  private final Map<String, GaugeSnapshot.Builder> gauges = new LinkedHashMap<>();
  private final Map<String, CounterSnapshot.Builder> counters = new LinkedHashMap<>();
  private final Map<String, HistogramSnapshot.Builder> histograms = new LinkedHashMap<>();

  private static double[] bounds(int first, int last) {
    double[] bounds = new double[last - first + 2];
    for (int i = first; i <= last; i++) {
      bounds[i - first] = (1L << i) / 1e9;
    }
    bounds[bounds.length - 1] = Double.POSITIVE_INFINITY;
    return bounds;
  }

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

  /** Adds a distribution of times. Their sum is up to 12.5 % too high, as the client rounds up. */
  void histogram(String name, String help, Labels labels, ClientStatistics.Histogram times) {
    long[] counts = new long[BOUNDS.length];
    double[] sum = new double[1];
    times.forEach(
        (upTo, count) -> {
          double seconds = upTo.toNanos() / 1e9;
          int bucket = 0;
          while (seconds > BOUNDS[bucket]) {
            bucket++;
          }
          counts[bucket] += count;
          sum[0] += seconds * count;
        });
    histograms
        .computeIfAbsent(name, it -> HistogramSnapshot.builder().name(PREFIX + it).help(help))
        .dataPoint(
            HistogramSnapshot.HistogramDataPointSnapshot.builder()
                .labels(labels)
                .classicHistogramBuckets(ClassicHistogramBuckets.of(BOUNDS, counts))
                .sum(sum[0])
                .build());
  }

  MetricSnapshots snapshots() {
    MetricSnapshots.Builder all = MetricSnapshots.builder();
    gauges.values().forEach(one -> all.metricSnapshot(one.build()));
    counters.values().forEach(one -> all.metricSnapshot(one.build()));
    histograms.values().forEach(one -> all.metricSnapshot(one.build()));
    return all.build();
  }
}
