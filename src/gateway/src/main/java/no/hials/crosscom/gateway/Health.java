package no.hials.crosscom.gateway;

import io.prometheus.metrics.core.metrics.Counter;
import io.prometheus.metrics.core.metrics.Gauge;
import io.prometheus.metrics.model.registry.PrometheusRegistry;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** The figures of the gateway itself, which an output can publish. */
public final class Health {
  private final PrometheusRegistry registry = new PrometheusRegistry();
  private final Map<String, Counter> counters = new ConcurrentHashMap<>();
  private final Map<String, Gauge> gauges = new ConcurrentHashMap<>();

  /**
   * Returns a counter. An output that restarts gets its earlier counter.
   *
   * @param name the name after {@code jopenshowvar_}, without {@code _total}
   */
  public Counter counter(String name, String help, String... labels) {
    return counters.computeIfAbsent(
        name,
        it ->
            Counter.builder()
                .name("jopenshowvar_" + it)
                .help(help)
                .labelNames(labels)
                .register(registry));
  }

  /**
   * Returns a gauge. An output that restarts gets its earlier gauge.
   *
   * @param name the name after {@code jopenshowvar_}
   */
  public Gauge gauge(String name, String help, String... labels) {
    return gauges.computeIfAbsent(
        name,
        it ->
            Gauge.builder()
                .name("jopenshowvar_" + it)
                .help(help)
                .labelNames(labels)
                .register(registry));
  }

  /** Returns the registry of all figures. */
  public PrometheusRegistry registry() {
    return registry;
  }
}
