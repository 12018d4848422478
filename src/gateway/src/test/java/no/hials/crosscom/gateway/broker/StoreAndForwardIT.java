package no.hials.crosscom.gateway.broker;

import static org.assertj.core.api.Assertions.assertThat;

import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5Publish;
import io.reactivex.plugins.RxJavaPlugins;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import no.hials.crosscom.gateway.Gateway;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class StoreAndForwardIT extends BrokerTest {
  private static final String COUNTER = "robots/cell1/COUNTER";
  private static final Pattern VALUE = Pattern.compile("\"value\":(\\d+),.*\"good\"");
  private static final String COUNT =
      """
      [groups.all]
      variables = ["COUNTER"]
      period = "5ms"
      on-change = true
      """;

  @BeforeEach
  void declareCounter() {
    robot.variables().declare("COUNTER", "INT", "0");
  }

  /** Makes the gateway read each of these numbers. */
  private void count(Gateway reading, int from, int to) {
    for (int i = from; i <= to; i++) {
      String next = String.valueOf(i);
      robot.variables().set("COUNTER", next);
      await(
          () ->
              reading
                  .robots()
                  .get(0)
                  .lastValue("COUNTER")
                  .filter(it -> it.print().equals(next))
                  .isPresent());
    }
  }

  private static Optional<Integer> number(Mqtt5Publish message) {
    Matcher matcher = VALUE.matcher(Observer.text(message));
    return message.getTopic().toString().equals(COUNTER) && matcher.find()
        ? Optional.of(Integer.valueOf(matcher.group(1)))
        : Optional.empty();
  }

  private static List<Integer> numbers(List<Mqtt5Publish> messages) {
    return messages.stream().map(StoreAndForwardIT::number).flatMap(Optional::stream).toList();
  }

  private static List<Integer> upTo(int last) {
    return IntStream.rangeClosed(1, last).boxed().toList();
  }

  @Test
  void nothingIsLostWhenTheBrokerRestarts() throws Exception {
    broker = Mosquitto.open(folder);
    List<Integer> before;
    try (Cable cable = new Cable(broker.port())) {
      cable.connect();
      Gateway reading = start(COUNT + mqtt(cable));
      try (Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
        observer.await(COUNTER, "good");
        count(reading, 1, 20);
        before = numbers(observer.await(all -> numbers(all).contains(20)));
        cable.cut();
        broker.kill();
      }
      count(reading, 21, 200);
      broker.start();
      try (Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
        cable.connect();
        await(() -> figure(reading, "mqtt_connected") == 1);
        count(reading, 201, 220);
        List<Mqtt5Publish> all =
            observer.await(
                it -> numbers(it).contains(220) && figure(reading, "mqtt_store_messages") == 0);

        assertThat(before).containsSubsequence(upTo(20));
        assertThat(numbers(all)).containsAll(upTo(220).subList(20, 220));
        List<Mqtt5Publish> stored = all.stream().filter(it -> !it.isRetain()).toList();
        assertThat(numbers(stored)).isSorted().containsAll(upTo(200).subList(20, 200));
        assertThat(figure(reading, "mqtt_messages_dropped")).isZero();
        await(() -> lines.get().contains("MQTT plain: all stored messages are forwarded"));
      }
      try (Observer late = new Observer(broker.port()).subscribe(COUNTER)) {
        assertThat(number(late.await(all -> !all.isEmpty()).get(0))).contains(220);
      }
    }
  }

  @Test
  void theLastMessageAfterAnOutageIsTheValueOfNow() throws Exception {
    broker = Mosquitto.open(folder);
    try (Cable cable = new Cable(broker.port());
        Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
      Gateway reading = start(COUNT + mqtt(cable));
      count(reading, 1, 50);

      cable.connect();

      List<Mqtt5Publish> all =
          observer.await(
              it ->
                  numbers(it.stream().filter(one -> !one.isRetain()).toList()).contains(50)
                      && it.get(it.size() - 1).isRetain());
      assertThat(number(all.get(all.size() - 1))).contains(50);
    }
  }

  @Test
  void aGatewayThatRestartsForwardsWhatIsStored() throws Exception {
    broker = Mosquitto.open(folder);
    try (Cable cable = new Cable(broker.port());
        Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
      Gateway reading = start(COUNT + mqtt(cable));
      count(reading, 1, 60);
      reading.close();
      robot.variables().set("COUNTER", "61");

      cable.connect();
      start(COUNT + mqtt(cable));

      observer.await(all -> numbers(all).containsAll(upTo(61)));
    }
  }

  @Test
  void connectsAfterAnAttemptThatFailsAtOnce() throws Exception {
    broker = Mosquitto.open(folder);
    AtomicBoolean failed = new AtomicBoolean();
    // as when the process has too many open files: the MQTT client throws
    RxJavaPlugins.setOnSingleSubscribe(
        (single, observer) -> {
          if (failed.compareAndSet(false, true)) {
            throw new IllegalStateException("too many open files");
          }
          return observer;
        });
    try {
      Gateway running = start(COUNT + mqtt(broker));

      await(() -> figure(running, "mqtt_connected") == 1);
      assertThat(failed).isTrue();
    } finally {
      RxJavaPlugins.setOnSingleSubscribe(null);
    }
  }

  @Test
  void aFullStoreDropsTheOldestAndCountsThem() throws Exception {
    broker = Mosquitto.open(folder);
    try (Cable cable = new Cable(broker.port());
        Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
      Gateway reading =
          start(
              """
              [groups.all]
              variables = ["$POS_ACT", "$AXIS_ACT", "$POS_INT", "$AXIS_INT", "$OV_PRO"]
              period = "5ms"
              """
                  + mqtt(cable, "store-limit = \"100 kB\""));
      await(() -> figure(reading, "mqtt_messages_dropped") > 500);
      robot.refuseConnections();
      robot.disconnectClients();
      await(() -> !reading.robots().get(0).isConnected());
      await(() -> figure(reading, "mqtt_store_bytes") <= 100_000);

      cable.connect();
      await(
          () ->
              figure(reading, "mqtt_connected") == 1
                  && figure(reading, "mqtt_store_messages") == 0);

      double kept =
          figure(reading, "mqtt_messages_stored") - figure(reading, "mqtt_messages_dropped");
      observer.await(all -> all.stream().filter(it -> !it.isRetain()).count() == (long) kept);
    }
  }

  @Test
  void aDiskThatTakesNothingIsCountedAndStopsNothing() throws Exception {
    broker = Mosquitto.open(folder);
    Path data = Files.createDirectories(folder.resolve("data"));
    Files.writeString(data.resolve("mqtt-store"), "not a folder");
    try (Cable cable = new Cable(broker.port());
        Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
      Gateway reading = start(COUNT + mqtt(cable));
      count(reading, 1, 30);
      await(() -> figure(reading, "mqtt_messages_dropped") >= 30);

      cable.connect();

      observer.await(all -> numbers(all).contains(30));
      count(reading, 31, 32);
      observer.await(all -> numbers(all).contains(32));
    }
  }

  @Test
  void theWillTellsThatTheGatewayIsLost() throws IOException, InterruptedException {
    broker = Mosquitto.open(folder);
    try (Cable cable = new Cable(broker.port());
        Observer observer = new Observer(broker.port()).subscribe("robots/gateway/status")) {
      start(COUNT + mqtt(cable));
      cable.connect();
      observer.await("robots/gateway/status", "online");

      cable.cut();

      observer.await("robots/gateway/status", "offline");
      observer.forget();
      cable.connect();
      observer.await("robots/gateway/status", "online");
    }
  }
}
