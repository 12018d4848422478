package no.hials.crosscom.web.internal.teach;

import java.time.Duration;
import java.util.Optional;
import java.util.Random;
import java.util.function.UnaryOperator;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;

/** The faults of a simulated robot's server that a teacher has switched on. Thread-safe. */
final class ServerFaults {
  private final MockServer server;
  private final Random random = new Random();
  private Settings settings = Settings.NONE;

  /**
   * The faults.
   *
   * @param latencyMillis the delay of each answer
   * @param lostPercent the percentage of requests that are executed and never answered
   * @param silent whether no request is executed or answered
   */
  record Settings(int latencyMillis, int lostPercent, boolean silent) {
    static final Settings NONE = new Settings(0, 0, false);
  }

  ServerFaults(MockServer server) {
    this.server = server;
    server.faults(this::choose);
  }

  synchronized Settings settings() {
    return settings;
  }

  synchronized void set(UnaryOperator<Settings> change) {
    settings = change.apply(settings);
  }

  private synchronized Optional<Fault> choose(RecordedRequest request) {
    if (settings.silent()) {
      return Optional.of(Fault.drop());
    }
    if (random.nextInt(100) < settings.lostPercent()) {
      return Optional.of(Fault.dropAnswer());
    }
    return settings.latencyMillis() == 0
        ? Optional.empty()
        : Optional.of(Fault.delay(Duration.ofMillis(settings.latencyMillis())));
  }

  /** Loses the answer to the next request. */
  void loseNextAnswer() {
    server.enqueue(Fault.dropAnswer());
  }

  /** Closes all connections to the server. Clients may connect again at once. */
  void cutConnections() {
    server.disconnectClients();
  }
}
