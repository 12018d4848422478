package no.hials.crosscom.gateway.internal.broker;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.hivemq.client.mqtt.MqttClientBuilder;
import com.hivemq.client.mqtt.datatypes.MqttQos;
import com.hivemq.client.mqtt.mqtt5.Mqtt5AsyncClient;
import com.hivemq.client.mqtt.mqtt5.Mqtt5ClientConnectionConfig.RestrictionsForClient;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5UnsubAckException;
import com.hivemq.client.mqtt.mqtt5.message.auth.Mqtt5SimpleAuth;
import com.hivemq.client.mqtt.mqtt5.message.auth.Mqtt5SimpleAuthBuilder;
import com.hivemq.client.mqtt.mqtt5.message.connect.Mqtt5Connect;
import com.hivemq.client.mqtt.mqtt5.message.connect.Mqtt5ConnectBuilder;
import com.hivemq.client.mqtt.mqtt5.message.disconnect.Mqtt5DisconnectReasonCode;
import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5Publish;
import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5PublishBuilder;
import com.hivemq.client.mqtt.mqtt5.message.subscribe.Mqtt5RetainHandling;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Objects;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.ToIntFunction;
import no.hials.crosscom.gateway.internal.broker.Traffic.TopicFilter;
import org.jspecify.annotations.Nullable;

/** A connection with MQTT 5. */
final class Mqtt5Link implements Link {
  /** The user property in which a client can name itself. */
  private static final String SENDER = "client-id";

  /** The receive maximum of a broker that has none. */
  private static final int LARGEST = 65_535;

  private final Mqtt5AsyncClient client;
  private final Mqtt5Connect connect;
  private final RoundTrips roundTrips = new RoundTrips(this::ask);

  Mqtt5Link(
      MqttClientBuilder builder,
      @Nullable String user,
      @Nullable String password,
      Publication will) {
    client = builder.useMqttVersion5().buildAsync();
    Mqtt5ConnectBuilder connecting =
        Mqtt5Connect.builder()
            .cleanStart(true)
            .keepAlive(KEEP_ALIVE_SECONDS)
            .willPublish(message(will));
    if (user != null) {
      Mqtt5SimpleAuthBuilder.Complete login = Mqtt5SimpleAuth.builder().username(user);
      connecting =
          connecting.simpleAuth(
              password == null ? login.build() : login.password(password.getBytes(UTF_8)).build());
    }
    connect = connecting.build();
  }

  private static Mqtt5Publish message(Publication message) {
    Mqtt5PublishBuilder.Complete builder =
        Mqtt5Publish.builder()
            .topic(message.topic())
            .payload(message.payload())
            .qos(Objects.requireNonNull(MqttQos.fromCode(message.qos())))
            .retain(message.retained());
    if (message.correlation() != null) {
      builder = builder.correlationData(message.correlation());
    }
    return builder.build();
  }

  @Override
  public CompletableFuture<?> connect() {
    return client.connect(connect);
  }

  @Override
  public CompletableFuture<?> subscribe(TopicFilter filter) {
    return client
        .subscribeWith()
        .topicFilter(filter.filter())
        .qos(Objects.requireNonNull(MqttQos.fromCode(filter.qos())))
        .retainHandling(Mqtt5RetainHandling.SEND)
        .retainAsPublished(true)
        .callback(message -> filter.receiver().accept(received(message)))
        .send();
  }

  private static Received received(Mqtt5Publish message) {
    String sender =
        message.getUserProperties().asList().stream()
            .filter(property -> property.getName().toString().equals(SENDER))
            .map(property -> property.getValue().toString())
            .findFirst()
            .orElse("");
    OptionalLong expiry = message.getMessageExpiryInterval();
    return new Received(
        message.getTopic().toString(),
        ByteBuffer.wrap(message.getPayloadAsBytes()),
        message.isRetain(),
        sender,
        message.getResponseTopic().map(Object::toString).orElse(null),
        message.getCorrelationData().orElse(null),
        expiry.isPresent() ? Duration.ofSeconds(expiry.getAsLong()) : null);
  }

  @Override
  public CompletableFuture<?> publish(Publication message) {
    return client.publish(message(message));
  }

  @Override
  public CompletableFuture<?> roundTrip(int size, int most) {
    return roundTrips.next(size, most);
  }

  private CompletableFuture<?> ask() {
    return client
        .unsubscribeWith()
        .topicFilter(NO_SUBSCRIPTION)
        .send()
        .handle(
            (answer, failure) -> {
              // a refusal is an answer, too
              if (failure != null && !(Link.cause(failure) instanceof Mqtt5UnsubAckException)) {
                throw new CompletionException(Link.cause(failure));
              }
              return true;
            });
  }

  private int restriction(ToIntFunction<RestrictionsForClient> which) {
    return client
        .getConfig()
        .getConnectionConfig()
        .map(connection -> which.applyAsInt(connection.getRestrictionsForClient()))
        .orElse(Integer.MAX_VALUE);
  }

  @Override
  public int mostBytes() {
    return restriction(RestrictionsForClient::getSendMaximumPacketSize);
  }

  @Override
  public int mostInFlight(int qos) {
    return qos == 0
        ? Integer.MAX_VALUE
        : 2 * Math.min(LARGEST, restriction(RestrictionsForClient::getSendMaximum));
  }

  @Override
  public CompletableFuture<?> disconnect() {
    return client.disconnect();
  }

  @Override
  public CompletableFuture<?> disconnectWithWill() {
    return client
        .disconnectWith()
        .reasonCode(Mqtt5DisconnectReasonCode.DISCONNECT_WITH_WILL_MESSAGE)
        .send();
  }
}
