package no.hials.crosscom.gateway.broker;

import com.hivemq.client.mqtt.MqttClient;
import com.hivemq.client.mqtt.MqttClientSslConfig;
import com.hivemq.client.mqtt.datatypes.MqttQos;
import com.hivemq.client.mqtt.mqtt5.Mqtt5AsyncClient;
import com.hivemq.client.mqtt.mqtt5.Mqtt5ClientBuilder;
import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5Publish;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;

/** A client that keeps all messages it gets, in order. */
final class Observer implements AutoCloseable {
  private static final long PATIENCE = Duration.ofSeconds(20).toNanos();

  private final Mqtt5AsyncClient client;
  private final List<Mqtt5Publish> messages = new ArrayList<>();

  Observer(int port) {
    this("127.0.0.1", port, null, null, null);
  }

  Observer(
      String host,
      int port,
      @Nullable String user,
      @Nullable String password,
      @Nullable MqttClientSslConfig tls) {
    Mqtt5ClientBuilder builder =
        MqttClient.builder().useMqttVersion5().serverHost(host).serverPort(port);
    if (tls != null) {
      builder = builder.sslConfig(tls);
    }
    if (user != null && password != null) {
      builder =
          builder
              .simpleAuth()
              .username(user)
              .password(password.getBytes(StandardCharsets.UTF_8))
              .applySimpleAuth();
    }
    client = builder.buildAsync();
    client.connect().orTimeout(20, TimeUnit.SECONDS).join();
  }

  /** Subscribes, and returns when the broker has confirmed. */
  Observer subscribe(String filter) {
    client
        .subscribeWith()
        .topicFilter(filter)
        .qos(MqttQos.AT_LEAST_ONCE)
        .retainAsPublished(true)
        .callback(this::add)
        .send()
        .orTimeout(20, TimeUnit.SECONDS)
        .join();
    return this;
  }

  private synchronized void add(Mqtt5Publish message) {
    messages.add(message);
    notifyAll();
  }

  /** Returns the messages of a topic. */
  synchronized List<Mqtt5Publish> on(String topic) {
    return messages.stream().filter(it -> it.getTopic().toString().equals(topic)).toList();
  }

  /** Returns all messages. */
  synchronized List<Mqtt5Publish> all() {
    return List.copyOf(messages);
  }

  synchronized void forget() {
    messages.clear();
  }

  static String text(Mqtt5Publish message) {
    return new String(message.getPayloadAsBytes(), StandardCharsets.UTF_8);
  }

  /** Waits until the messages are as expected, and returns them. */
  synchronized List<Mqtt5Publish> await(Predicate<List<Mqtt5Publish>> condition)
      throws InterruptedException {
    long end = System.nanoTime() + PATIENCE;
    while (!condition.test(messages)) {
      long left = end - System.nanoTime();
      if (left <= 0) {
        throw new AssertionError(
            "not in time; the last messages: "
                + messages.subList(Math.max(0, messages.size() - 20), messages.size()).stream()
                    .map(it -> it.getTopic() + " " + text(it))
                    .toList());
      }
      TimeUnit.NANOSECONDS.timedWait(this, left);
    }
    return List.copyOf(messages);
  }

  /** Waits for a message of a topic that contains a text, and returns the first one. */
  Mqtt5Publish await(String topic, String part) throws InterruptedException {
    Predicate<Mqtt5Publish> wanted =
        it -> it.getTopic().toString().equals(topic) && text(it).contains(part);
    return await(all -> all.stream().anyMatch(wanted)).stream()
        .filter(wanted)
        .findFirst()
        .orElseThrow();
  }

  /** Publishes a message, and returns when the broker has it. */
  void publish(Mqtt5Publish message) {
    client.publish(message).orTimeout(20, TimeUnit.SECONDS).join();
  }

  void publish(String topic, String payload, boolean retained) {
    publish(
        Mqtt5Publish.builder()
            .topic(topic)
            .payload(payload.getBytes(StandardCharsets.UTF_8))
            .qos(MqttQos.AT_LEAST_ONCE)
            .retain(retained)
            .build());
  }

  @Override
  public void close() {
    client.disconnect().orTimeout(20, TimeUnit.SECONDS).exceptionally(failure -> null).join();
  }
}
