package no.hials.crosscom;

/** Listens to connects and losses of a client's connection. */
@FunctionalInterface
public interface ConnectionListener {
  /**
   * Called after each event, in a thread of the {@link ClientRuntime}, one event after the other. A
   * slow listener delays only further events.
   *
   * @param event what happened
   */
  void connectionChanged(ConnectionEvent event);
}
