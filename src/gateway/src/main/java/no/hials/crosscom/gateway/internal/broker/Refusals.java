package no.hials.crosscom.gateway.internal.broker;

import com.hivemq.client.mqtt.exceptions.MqttEncodeException;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5PubAckException;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5PubRecException;
import com.hivemq.client.mqtt.mqtt5.message.Mqtt5ReasonCode;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Counts and logs the messages that a broker refuses: one line for a topic, since the next messages
 * of the topic are usually refused for the same reason. Not thread-safe.
 */
final class Refusals {
  private static final Logger LOG = LoggerFactory.getLogger(Refusals.class);

  /** The maximum number of lines: the login of a large plant may have no right at all. */
  private static final int MAX_TOPICS = 20;

  private final String session;
  private final SessionFigures figures;
  private final Culprits culprits;
  private final Set<String> topics = new HashSet<>();

  /**
   * Creates a log without topics.
   *
   * @param session the name of the session
   */
  Refusals(String session, SessionFigures figures, Culprits culprits) {
    this.session = session;
    this.culprits = culprits;
    this.figures = figures;
  }

  /** Returns whether a message was refused, and not lost with its connection. */
  static boolean isRefusal(Throwable cause) {
    return cause instanceof Mqtt5PubAckException
        || cause instanceof Mqtt5PubRecException
        || cause instanceof MqttEncodeException;
  }

  /** Adds a refusal that the broker or the client has answered. */
  void add(String topic, Throwable cause) {
    add(topic, reason(cause));
  }

  /**
   * Returns whether a message is sent. If not, adds a refusal.
   *
   * @param name its name for {@link Culprits}
   */
  boolean accept(Publication message, String name, @Nullable Link link, long now) {
    int most = link == null ? Integer.MAX_VALUE : link.mostBytes();
    String reason = culprits.reasonAgainst(message, name, most, now);
    if (!reason.isEmpty()) {
      add(message.topic(), reason);
    }
    return reason.isEmpty();
  }

  /** Adds a refusal. */
  private void add(String topic, String reason) {
    figures.dropped("refused", 1);
    if (topics.size() == MAX_TOPICS || !topics.add(topic)) {
      return;
    }
    LOG.warn(
        "MQTT {}: the broker refuses {}: {}; {}",
        session,
        topic,
        reason,
        topics.size() < MAX_TOPICS
            ? "further refusals of the topic are only counted"
            : "all further refusals are only counted");
  }

  private static String reason(Throwable cause) {
    Mqtt5ReasonCode code = code(cause);
    return code == null
        ? String.valueOf(cause.getMessage())
        : code.toString().toLowerCase(Locale.ROOT).replace('_', ' ');
  }

  private static @Nullable Mqtt5ReasonCode code(Throwable cause) {
    if (cause instanceof Mqtt5PubAckException refusal) {
      return refusal.getMqttMessage().getReasonCode();
    }
    return cause instanceof Mqtt5PubRecException refusal
        ? refusal.getMqttMessage().getReasonCode()
        : null;
  }

  /** Begins again; called when the broker is connected. */
  void clear() {
    topics.clear();
  }
}
