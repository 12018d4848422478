package no.hials.crosscom.gateway.internal.broker;

import com.hivemq.client.mqtt.MqttClient;
import com.hivemq.client.mqtt.MqttClientBuilder;
import com.hivemq.client.mqtt.MqttClientSslConfig;
import com.hivemq.client.mqtt.exceptions.ConnectionClosedException;
import com.hivemq.client.mqtt.exceptions.ConnectionFailedException;
import com.hivemq.client.mqtt.mqtt3.exceptions.Mqtt3SubAckException;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5DisconnectException;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5SubAckException;
import com.hivemq.client.mqtt.mqtt5.message.disconnect.Mqtt5DisconnectReasonCode;
import java.io.IOException;
import java.nio.channels.ClosedChannelException;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.gateway.internal.broker.Traffic.TopicFilter;
import org.jspecify.annotations.Nullable;

/** One connection to a broker, which does not reconnect. */
interface Link {
  /** The period of keep-alives; a broker that is silent for two periods counts as lost. */
  int KEEP_ALIVE_SECONDS = 7;

  /** The topic filter of questions, which has no subscription. */
  String NO_SUBSCRIPTION = "jopenshowvar/round-trip";

  /** The maximum time until the broker answers the first message of a connection. */
  int CONNECT_SECONDS = 20;

  /** The reasons of MQTT 5 for which a broker ends a connection that are not about messages. */
  Set<Mqtt5DisconnectReasonCode> OTHER_REASONS =
      EnumSet.of(
          Mqtt5DisconnectReasonCode.SERVER_BUSY,
          Mqtt5DisconnectReasonCode.SERVER_SHUTTING_DOWN,
          Mqtt5DisconnectReasonCode.KEEP_ALIVE_TIMEOUT,
          Mqtt5DisconnectReasonCode.SESSION_TAKEN_OVER,
          Mqtt5DisconnectReasonCode.USE_ANOTHER_SERVER,
          Mqtt5DisconnectReasonCode.SERVER_MOVED,
          Mqtt5DisconnectReasonCode.CONNECTION_RATE_EXCEEDED,
          Mqtt5DisconnectReasonCode.MAXIMUM_CONNECT_TIME);

  /** Connects with a clean session: the broker keeps no messages for this client. */
  CompletableFuture<?> connect();

  /** Subscribes to a topic filter. */
  CompletableFuture<?> subscribe(TopicFilter filter);

  /**
   * Subscribes to several topic filters.
   *
   * @param inUse tells whether a message may be passed on
   * @param refused called with each filter that the broker refuses, and the reason
   * @return completes when the broker has answered all
   */
  default CompletableFuture<?> subscribe(
      List<TopicFilter> filters, BooleanSupplier inUse, BiConsumer<String, Throwable> refused) {
    return CompletableFuture.allOf(
        filters.stream()
            .map(
                one ->
                    subscribe(one.onlyIf(inUse))
                        .handle(
                            (result, failure) -> {
                              Throwable cause = cause(failure);
                              if (cause instanceof Mqtt3SubAckException
                                  || cause instanceof Mqtt5SubAckException) {
                                refused.accept(one.filter(), cause);
                              } else if (cause != null) {
                                throw new CompletionException(cause);
                              }
                              return result;
                            }))
            .toArray(CompletableFuture<?>[]::new));
  }

  /**
   * Publishes a message. The future completes when the broker has the message, as far as the
   * quality of service confirms it.
   */
  CompletableFuture<?> publish(Publication message);

  /**
   * Returns a future that completes when the broker has handled what was sent before.
   *
   * @param size the size of the message that was sent
   * @param most the number of bytes after which the broker is asked, also if it has not answered
   */
  CompletableFuture<?> roundTrip(int size, int most);

  /**
   * Publishes a message. The future completes when the broker has the message, also if the quality
   * of service does not confirm it.
   *
   * @param most the number of bytes after which the broker is asked, also if it has not answered
   */
  default CompletableFuture<?> publishConfirmed(Publication message, int most) {
    CompletableFuture<?> sent = publish(message);
    return message.qos() > 0
        ? sent
        : sent.thenCompose(unused -> roundTrip(message.payload().remaining(), most));
  }

  /** Returns the maximum size of a packet that the broker accepts, in bytes. */
  int mostBytes();

  /**
   * Returns the maximum number of messages on their way. It is twice what the broker takes at a
   * time, so that it always has the next ones.
   *
   * @param qos their quality of service
   */
  int mostInFlight(int qos);

  /** Disconnects, so that the broker does not publish the will. */
  CompletableFuture<?> disconnect();

  /** Disconnects, so that the broker publishes the will. */
  CompletableFuture<?> disconnectWithWill();

  /**
   * Creates a link.
   *
   * @param lost called with the reason when the connection is lost or fails
   * @throws IOException if the files of the settings cannot be read
   */
  static Link create(BrokerSettings settings, Publication will, Consumer<Throwable> lost)
      throws IOException {
    MqttClientBuilder builder =
        MqttClient.builder()
            .transportConfig()
            .mqttConnectTimeout(CONNECT_SECONDS, TimeUnit.SECONDS)
            .applyTransportConfig()
            .serverHost(settings.host())
            .serverPort(settings.port())
            .addDisconnectedListener(context -> lost.accept(context.getCause()));
    if (settings.clientId() != null) {
      builder = builder.identifier(settings.clientId());
    }
    if (settings.tls()) {
      // without an explicit verifier, the client checks the name of the host as for HTTPS
      builder =
          builder.sslConfig(
              settings.caFile() == null
                  ? MqttClientSslConfig.builder().build()
                  : MqttClientSslConfig.builder()
                      .trustManagerFactory(BrokerSettings.trust(settings.caFile()))
                      .build());
    }
    String password = password(settings);
    return settings.version() == 5
        ? new Mqtt5Link(builder, settings.user(), password, will)
        : new Mqtt3Link(builder, settings.user(), password, will);
  }

  /** Returns the failure of a step of a future. */
  static @Nullable Throwable cause(@Nullable Throwable failure) {
    return failure instanceof CompletionException && failure.getCause() != null
        ? failure.getCause()
        : failure;
  }

  /**
   * Returns whether the broker may have ended a connection because of a message, and not because it
   * is shut down, or the client was silent or is connected a second time.
   */
  static boolean isEndedByBroker(Throwable failure) {
    if (isInvalidPacket(failure)) {
      return false;
    }
    return failure instanceof Mqtt5DisconnectException message
        ? !OTHER_REASONS.contains(message.getMqttMessage().getReasonCode())
        : failure instanceof ConnectionClosedException;
  }

  /**
   * Returns whether this client has ended a connection because of an invalid packet. Some brokers
   * pass on invalid messages of other clients.
   */
  static boolean isInvalidPacket(Throwable failure) {
    return failure instanceof Mqtt5DisconnectException
        && String.valueOf(failure.getMessage()).startsWith("Exception while decoding");
  }

  /** Returns why a connection was lost or not made. */
  static String reason(Throwable failure) {
    if (isInvalidPacket(failure)) {
      return "the broker has passed on an invalid message: " + failure.getMessage();
    }
    Throwable cause = failure.getCause();
    boolean wraps =
        failure instanceof ConnectionFailedException
            || failure instanceof ConnectionClosedException;
    Throwable first = wraps && cause != null ? cause : failure;
    return first instanceof ClosedChannelException
        ? "the connection was closed"
        : String.valueOf(first.getMessage());
  }

  private static @Nullable String password(BrokerSettings settings) throws FileException {
    return settings.passwordFile() == null
        ? null
        : BrokerSettings.password(settings.passwordFile());
  }
}
