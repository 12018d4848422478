package no.hials.crosscom.gateway.internal.broker;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.hivemq.client.mqtt.MqttClientBuilder;
import com.hivemq.client.mqtt.datatypes.MqttQos;
import com.hivemq.client.mqtt.mqtt3.Mqtt3AsyncClient;
import com.hivemq.client.mqtt.mqtt3.message.auth.Mqtt3SimpleAuth;
import com.hivemq.client.mqtt.mqtt3.message.auth.Mqtt3SimpleAuthBuilder;
import com.hivemq.client.mqtt.mqtt3.message.connect.Mqtt3Connect;
import com.hivemq.client.mqtt.mqtt3.message.connect.Mqtt3ConnectBuilder;
import com.hivemq.client.mqtt.mqtt3.message.publish.Mqtt3Publish;
import java.nio.ByteBuffer;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.gateway.internal.broker.Traffic.TopicFilter;
import org.jspecify.annotations.Nullable;

/** A connection with MQTT 3.1.1. */
final class Mqtt3Link implements Link {
  /** The maximum time until the broker confirms the will. */
  private static final int WILL_SECONDS = 1;

  /** Some brokers end a connection that has more messages on their way; mosquitto takes 20. */
  private static final int MOST_QOS_2 = 10;

  private final Mqtt3AsyncClient client;
  private final Publication will;
  private final Mqtt3Connect connect;
  private final RoundTrips roundTrips;

  Mqtt3Link(
      MqttClientBuilder builder,
      @Nullable String user,
      @Nullable String password,
      Publication will) {
    client = builder.useMqttVersion3().buildAsync();
    this.will = will;
    roundTrips = new RoundTrips(() -> client.unsubscribeWith().topicFilter(NO_SUBSCRIPTION).send());
    Mqtt3ConnectBuilder connecting =
        Mqtt3Connect.builder()
            .cleanSession(true)
            .keepAlive(KEEP_ALIVE_SECONDS)
            .willPublish(message(will));
    if (user != null) {
      Mqtt3SimpleAuthBuilder.Complete login = Mqtt3SimpleAuth.builder().username(user);
      connecting =
          connecting.simpleAuth(
              password == null ? login.build() : login.password(password.getBytes(UTF_8)).build());
    }
    connect = connecting.build();
  }

  private static Mqtt3Publish message(Publication message) {
    return Mqtt3Publish.builder()
        .topic(message.topic())
        .payload(message.payload())
        .qos(Objects.requireNonNull(MqttQos.fromCode(message.qos())))
        .retain(message.retained())
        .build();
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
        .callback(
            message ->
                filter
                    .receiver()
                    .accept(
                        new Received(
                            message.getTopic().toString(),
                            ByteBuffer.wrap(message.getPayloadAsBytes()),
                            message.isRetain(),
                            "",
                            null,
                            null,
                            null)))
        .send();
  }

  @Override
  public CompletableFuture<?> publish(Publication message) {
    return client.publish(message(message));
  }

  @Override
  public CompletableFuture<?> roundTrip(int size, int most) {
    return roundTrips.next(size, most);
  }

  @Override
  public int mostBytes() {
    return Integer.MAX_VALUE; // the broker does not tell it
  }

  @Override
  public int mostInFlight(int qos) {
    return qos == 2 ? MOST_QOS_2 : Integer.MAX_VALUE;
  }

  @Override
  public CompletableFuture<?> disconnect() {
    return client.disconnect();
  }

  @Override
  public CompletableFuture<?> disconnectWithWill() {
    // MQTT 3.1.1 has no message for it
    return publish(will)
        .orTimeout(WILL_SECONDS, TimeUnit.SECONDS)
        .handle((sent, failure) -> true)
        .thenCompose(tried -> client.disconnect());
  }
}
