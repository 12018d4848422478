package no.hials.crosscom.gateway.broker;

import static org.assertj.core.api.Assertions.assertThat;

import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5Publish;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PlainTopicsIT extends BrokerTest {
  /** As {@link #READ_ALL}, without the operating mode. */
  private static final String FEWER = READ_ALL.replace("\"$MODE_OP\", ", "");

  @ParameterizedTest
  @ValueSource(ints = {3, 5})
  void publishesEachVariableAsRetainedJson(int version) throws Exception {
    broker = Mosquitto.open(folder);
    robot.variables().set("$OV_PRO", "73");
    start(READ_ALL + mqtt(broker, "version = " + version));
    try (Observer first = new Observer(broker.port()).subscribe("robots/#")) {
      first.await("robots/cell1/$OV_PRO", "73");
      first.await("robots/cell1/$POS_ACT", "good");
      first.await("robots/cell1/$MODE_OP", "good");
      first.await("robots/cell1/NOSUCH", "bad");
    }

    try (Observer late = new Observer(broker.port()).subscribe("robots/#")) {
      Mqtt5Publish override = late.await("robots/cell1/$OV_PRO", "73");
      assertThat(override.isRetain()).isTrue();
      assertThat(Observer.text(override))
          .matches(
              "\\{\"time\":\"\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d\\.\\d{3}Z\",\"value\":73,"
                  + "\"unit\":\"%\",\"quality\":\"good\"}");
      assertThat(Observer.text(late.await("robots/cell1/$POS_ACT", "good")))
          .contains("\"value\":{\"X\":", "\"unit\":{\"X\":\"mm\",", "\"A\":\"\\u00B0\"");
      assertThat(Observer.text(late.await("robots/cell1/$MODE_OP", "good")))
          .contains("\"value\":\"#T1\"")
          .doesNotContain("unit");
      assertThat(Observer.text(late.await("robots/cell1/NOSUCH", "bad")))
          .contains("\"value\":null,\"quality\":\"bad\",\"reason\":\"")
          .contains("NOSUCH");
      late.await("robots/cell1/$status", "\"connected\"");
      assertThat(Observer.text(late.await("robots/gateway/status", ""))).isEqualTo("online");
    }
  }

  @Test
  void tellsThatARobotIsLostAndThatItIsBack() throws Exception {
    broker = Mosquitto.open(folder);
    start(READ_ALL + mqtt(broker, "topic = \"plant/hall 1\""));
    try (Observer observer = new Observer(broker.port()).subscribe("plant/hall 1/#")) {
      observer.await("plant/hall 1/cell1/$OV_PRO", "good");

      robot.refuseConnections();
      robot.disconnectClients();

      Mqtt5Publish stale = observer.await("plant/hall 1/cell1/$OV_PRO", "stale");
      assertThat(Observer.text(stale))
          .contains("\"value\":100", "\"quality\":\"stale\",\"reason\":\"");
      observer.await("plant/hall 1/cell1/$status", "\"disconnected\"");

      observer.forget();
      robot.acceptConnections();

      observer.await("plant/hall 1/cell1/$status", "\"connected\"");
      observer.await("plant/hall 1/cell1/$OV_PRO", "good");
    }
  }

  @Test
  void theWillTellsThatTheGatewayIsGone() throws Exception {
    broker = Mosquitto.open(folder);
    start(READ_ALL + mqtt(broker));
    try (Observer observer = new Observer(broker.port()).subscribe("robots/gateway/status")) {
      observer.await("robots/gateway/status", "online");

      gateway.close();

      observer.await("robots/gateway/status", "offline");
    }
  }

  @Test
  void theBrokerForgetsAVariableThatIsNoMoreRead() throws Exception {
    broker = Mosquitto.open(folder);
    start(READ_ALL + mqtt(broker));
    try (Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
      observer.await("robots/cell1/$MODE_OP", "good");

      gateway.apply(config(FEWER + mqtt(broker)));

      awaitDeletion(observer);
      observer.forget();
      observer.await("robots/cell1/$OV_PRO", "good");
    }
  }

  private static void awaitDeletion(Observer observer) throws InterruptedException {
    observer.await(
        all ->
            all.stream()
                .anyMatch(
                    it ->
                        it.getTopic().toString().equals("robots/cell1/$MODE_OP")
                            && it.getPayloadAsBytes().length == 0));
  }

  @Test
  void aDeletionThatTheBrokerDidNotGetIsRepeated() throws Exception {
    broker = Mosquitto.open(folder);
    try (Cable cable = new Cable(broker.port());
        Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
      cable.connect();
      start(READ_ALL + mqtt(cable));
      observer.await("robots/cell1/$MODE_OP", "good");

      cable.hold();
      gateway.apply(config(FEWER + mqtt(cable)));
      cable.awaitHeld();
      cable.cut();
      cable.connect();

      awaitDeletion(observer);
    }
  }

  @Test
  void aDeletionIsKeptWhenTheOutputChangesMeanwhile() throws Exception {
    broker = Mosquitto.open(folder);
    try (Cable cable = new Cable(broker.port());
        Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
      cable.connect();
      start(READ_ALL + mqtt(cable));
      observer.await("robots/cell1/$MODE_OP", "good");

      cable.cut();
      gateway.apply(config(FEWER + mqtt(cable)));
      gateway.apply(config(FEWER + mqtt(cable, "qos = 0")));
      cable.connect();

      awaitDeletion(observer);
    }
  }

  @Test
  void whatWasRemovedWhileTheGatewayDidNotRunIsDeleted() throws Exception {
    broker = Mosquitto.open(folder);
    try (Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
      start(READ_ALL + mqtt(broker));
      observer.await("robots/cell1/$MODE_OP", "good");
      gateway.close();

      start(FEWER + mqtt(broker));

      awaitDeletion(observer);
    }
  }

  @Test
  void theTopicsOfAnotherPrefixAreDeleted() throws Exception {
    broker = Mosquitto.open(folder);
    start(READ_ALL + mqtt(broker));
    try (Observer observer = new Observer(broker.port()).subscribe("#")) {
      observer.await("robots/cell1/$MODE_OP", "good");

      gateway.apply(config(READ_ALL + mqtt(broker, "topic = \"plant\"")));

      observer.await("plant/cell1/$MODE_OP", "good");
      observer.await(
          all -> {
            Map<String, Integer> lengths = new HashMap<>();
            all.forEach(it -> lengths.put(it.getTopic().toString(), it.getPayloadAsBytes().length));
            lengths.keySet().removeIf(topic -> topic.startsWith("plant/"));
            return lengths.size() == 6 && lengths.values().stream().allMatch(it -> it == 0);
          });
    }
  }
}
