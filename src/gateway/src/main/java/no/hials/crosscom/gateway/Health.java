package no.hials.crosscom.gateway;

import io.prometheus.metrics.core.metrics.Counter;
import io.prometheus.metrics.core.metrics.Gauge;
import io.prometheus.metrics.model.registry.PrometheusRegistry;

/** The figures of the gateway itself, which an output can publish. */
public final class Health {
  private final PrometheusRegistry registry = new PrometheusRegistry();

  /**
   * Creates a counter.
   *
   * @param name the name after {@code jopenshowvar_}, without {@code _total}
   */
  public Counter counter(String name, String help, String... labels) {
    return Counter.builder()
        .name("jopenshowvar_" + name)
        .help(help)
        .labelNames(labels)
        .register(registry);
  }

  /**
   * Creates a gauge.
   *
   * @param name the name after {@code jopenshowvar_}
   */
  public Gauge gauge(String name, String help, String... labels) {
    return Gauge.builder()
        .name("jopenshowvar_" + name)
        .help(help)
        .labelNames(labels)
        .register(registry);
  }

  /** Returns the registry of all figures. */
  public PrometheusRegistry registry() {
    return registry;
  }
}
