package no.hials.crosscom;

/** Hears what becomes of a client's connection. */
@FunctionalInterface
public interface ConnectionListener {
  /**
   * Takes an event. It is called by a thread of the client for this alone, {@code crosscom-events},
   * one event after the other; taking long delays further events and nothing else.
   *
   * @param event what happened
   */
  void connectionChanged(ConnectionEvent event);
}
