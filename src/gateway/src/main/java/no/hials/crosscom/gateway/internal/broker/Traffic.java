package no.hials.crosscom.gateway.internal.broker;

import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** The messages of a session. All methods but the receivers are called on its thread. */
public interface Traffic {
  /**
   * A subscription of a session.
   *
   * @param receiver called on a thread of the connection; it must not block
   */
  record TopicFilter(String filter, int qos, Consumer<Received> receiver) {
    /** Returns a subscription that drops messages while a condition does not hold. */
    TopicFilter onlyIf(BooleanSupplier condition) {
      return new TopicFilter(
          filter,
          qos,
          message -> {
            if (condition.getAsBoolean()) {
              receiver.accept(message);
            }
          });
    }
  }

  /** Returns the will of the next connection. */
  Publication will();

  /** Returns the subscriptions. */
  List<TopicFilter> subscriptions();

  /** Called when the broker is connected and has the subscriptions. */
  void connected();

  /** Called four times a second, whether connected or not. */
  void tick();

  /**
   * Called with each stored message, in order, while the broker is connected.
   *
   * @return whether the message was published or dropped; false to get it again later
   */
  boolean forward(StoredMessage message);

  /** Called when the broker has a message, or has refused it. */
  default void confirmed(Publication message) {}

  /** Called when the broker has all stored messages. */
  void forwarded();

  /** Called before the session disconnects. */
  void closing();
}
