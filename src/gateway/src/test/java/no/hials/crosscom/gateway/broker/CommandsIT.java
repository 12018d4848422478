package no.hials.crosscom.gateway.broker;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5Publish;
import java.nio.file.Files;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.gateway.Gateway;
import no.hials.crosscom.gateway.Latches;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.RecordedRequest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CommandsIT extends BrokerTest {
  private static final String READ =
      """
      [groups.all]
      variables = ["$OV_PRO", "$MODE_OP"]
      period = "50ms"
      on-change = true

      [variables."$OV_PRO"]
      write = true
      range = [0, 50]

      """;
  private static final String VALUE = "robots/cell1/$OV_PRO";
  private static final String SET = VALUE + "/set";
  private static final String RESULT = SET + "/result";

  private Gateway startWithCommands(String... lines) throws Exception {
    broker = Mosquitto.open(folder);
    robot.variables().set("$OV_PRO", "10");
    return start(READ + mqtt(broker, "commands = true\n" + String.join("\n", lines)));
  }

  private static Observer observer(Mosquitto broker) throws InterruptedException {
    Observer observer = new Observer(broker.port()).subscribe("robots/#");
    observer.await("robots/gateway/status", "online");
    observer.await(VALUE, "good");
    return observer;
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 5})
  void writesWhatIsAllowedAndTellsTheResult(int version) throws Exception {
    startWithCommands("version = " + version);
    try (Observer observer = observer(broker)) {
      observer.publish(SET, "20", false);

      assertThat(Observer.text(observer.await(RESULT, "")))
          .contains("\"value\":\"20\",\"result\":\"done\"");
      observer.await(VALUE, "\"value\":20");

      observer.publish("robots/cell1/$ov_pro/set", "{\"value\": 21}", false);

      observer.await("robots/cell1/$ov_pro/set/result", "done");
      observer.await(VALUE, "\"value\":21");
    }
    assertThat(Files.readString(folder.resolve("data/audit.jsonl")))
        .contains("\"who\":\"mqtt:unknown\",\"robot\":\"cell1\",\"what\":\"write\"");
  }

  @Test
  void answersToTheResponseTopicWithTheCorrelationData() throws Exception {
    startWithCommands();
    try (Observer observer = observer(broker).subscribe("answers").subscribe("others")) {
      Mqtt5Publish command =
          Mqtt5Publish.builder()
              .topic(SET)
              .payload("20".getBytes(UTF_8))
              .responseTopic("answers")
              .correlationData("id 1".getBytes(UTF_8))
              .userProperties()
              .add("client-id", "planner")
              .applyUserProperties()
              .build();
      observer.publish(command);

      Mqtt5Publish answer = observer.await("answers", "done");
      assertThat(answer.getCorrelationData().map(it -> UTF_8.decode(it).toString()))
          .contains("id 1");

      observer.publish(command);

      observer.await(
          "answers", "not executed: a command with the same response topic and correlation data");

      observer.publish(command.extend().responseTopic("others").build());

      observer.await("others", "done");
    }
    List<String> audit = Files.readAllLines(folder.resolve("data/audit.jsonl"));
    assertThat(audit).hasSize(2);
    assertThat(audit.get(0)).contains("mqtt:planner");
  }

  @Test
  void aCommandUnderWayEndsBeforeTheGateway() throws Exception {
    Gateway started = startWithCommands();
    CountDownLatch released = new CountDownLatch(1);
    CountDownLatch arrived = Latches.holdWrites(robot, released);
    try (Observer observer = observer(broker)) {
      observer.publish(SET, "20", false);
      arrived.await();

      Thread closing = new Thread(started::close);
      closing.start();
      await(() -> closing.getState() == Thread.State.TIMED_WAITING);
      released.countDown();

      observer.await(RESULT, "\"value\":\"20\",\"result\":\"done\"");
      closing.join();
    }
  }

  @Test
  void doesNotAnswerToATopicOfSparkplug() throws Exception {
    startWithCommands();
    String death = "spBv1.0/group/NDEATH/node";
    try (Observer observer = observer(broker).subscribe("spBv1.0/#")) {
      observer.publish(
          Mqtt5Publish.builder()
              .topic(SET)
              .payload("20".getBytes(UTF_8))
              .responseTopic(death)
              .build());
      observer.await(RESULT, "done");
      observer.publish(SET, "21", false);
      observer.await(RESULT, "\"value\":\"21\"");

      assertThat(observer.on(death)).isEmpty();
    }
  }

  @Test
  void refusesWhatTheConfigurationDoesNotAllow() throws Exception {
    startWithCommands();
    try (Observer observer = observer(broker)) {
      observer.publish(SET, "51", false);
      observer.await(RESULT, "must be 0.0 to 50.0, is 51");

      observer.publish(SET, "{\"value\": [1]}", false);
      observer.await(RESULT, "number, text or truth value");

      observer.publish("robots/cell1/$MODE_OP/set", "#T2", false);
      observer.await("robots/cell1/$MODE_OP/set/result", "the configuration does not allow it");

      observer.publish("robots/nobody/$OV_PRO/set", "20", false);
      observer.await("robots/nobody/$OV_PRO/set/result", "no robot is named nobody");
    }
    assertThat(robot.variables().get("$OV_PRO")).isEqualTo("10");
  }

  @Test
  void refusesACommandWithTooMuchCorrelationData() throws Exception {
    startWithCommands();
    try (Observer observer = observer(broker)) {
      observer.publish(
          Mqtt5Publish.builder()
              .topic(SET)
              .payload("20".getBytes(UTF_8))
              .responseTopic("answers")
              .correlationData(new byte[1000])
              .build());
      observer.publish(SET, "21", false);
      observer.await(RESULT, "\"value\":\"21\",\"result\":\"done\"");

      assertThat(observer.on(RESULT)).hasSize(1);
    }
    assertThat(robot.requests()).filteredOn(RecordedRequest::isWrite).hasSize(1);
  }

  @Test
  void refusesToWriteToARobotThatIsReadOnly() throws Exception {
    broker = Mosquitto.open(folder);
    start("read-only = true\n\n" + READ + mqtt(broker, "commands = true"));
    try (Observer observer = observer(broker)) {
      observer.publish(SET, "20", false);

      observer.await(RESULT, "was not written");
    }
    assertThat(robot.variables().get("$OV_PRO")).isEqualTo("100");
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 5})
  void neverExecutesARetainedCommand(int version) throws Exception {
    broker = Mosquitto.open(folder);
    robot.variables().set("$OV_PRO", "10");
    try (Observer observer = new Observer(broker.port())) {
      observer.publish(SET, "20", true);
      observer.subscribe("robots/#");

      start(READ + mqtt(broker, "commands = true", "version = " + version));

      observer.await(RESULT, "a retained command is not executed");
    }
    assertThat(robot.variables().get("$OV_PRO")).isEqualTo("10");
  }

  @Test
  void neverExecutesACommandThatIsPublishedRetainedWithMqtt5() throws Exception {
    startWithCommands();
    try (Observer observer = observer(broker)) {
      observer.publish(SET, "20", true);

      observer.await(RESULT, "a retained command is not executed");
    }
    assertThat(robot.variables().get("$OV_PRO")).isEqualTo("10");
  }

  @Test
  void executesACommandThatIsPublishedRetainedOnlyOnceWithMqtt3() throws Exception {
    broker = Mosquitto.open(folder);
    robot.variables().set("$OV_PRO", "10");
    try (Cable cable = new Cable(broker.port());
        Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
      cable.connect();
      String url = "url = \"tcp://127.0.0.1:" + cable.port() + "\"\n";
      start(READ + "[mqtt]\ncommands = true\nversion = 3\nclient-id = \"gw\"\n" + url);
      observer.await(VALUE, "\"value\":10");

      // the broker passes it on unmarked: docs/reference/gateway.md#commands
      observer.publish(SET, "20", true);
      observer.await(RESULT, "done");

      cable.cut();
      cable.connect();
      observer.await(RESULT, "a retained command is not executed");
    }
    assertThat(Files.readAllLines(folder.resolve("data/audit.jsonl"))).hasSize(1);
  }

  @Test
  void executesNothingThatWaitedInTheBroker() throws Exception {
    broker = Mosquitto.open(folder);
    robot.variables().set("$OV_PRO", "10");
    try (Cable cable = new Cable(broker.port());
        Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
      cable.connect();
      Gateway reading =
          start(
              READ
                  + "[mqtt]\ncommands = true\nclient-id = \"gw\"\nurl = \"tcp://127.0.0.1:"
                  + cable.port()
                  + "\"\n");
      observer.await("robots/gateway/status", "online");
      cable.cut();
      observer.await("robots/gateway/status", "offline");
      await(() -> figure(reading, "mqtt_connected") == 0);
      observer.publish(SET, "20", false);
      cable.connect();
      await(() -> figure(reading, "mqtt_connected") == 1);

      observer.publish(SET, "30", false);

      observer.await(RESULT, "done");
    }
    List<String> audit = Files.readAllLines(folder.resolve("data/audit.jsonl"));
    assertThat(audit).hasSize(1);
    assertThat(audit.get(0)).contains("\"after\":\"30\"");
  }

  @Test
  void executesNothingWithoutTheSetting() throws Exception {
    broker = Mosquitto.open(folder);
    robot.variables().set("$OV_PRO", "10");
    start(READ + mqtt(broker));
    try (Observer observer = observer(broker)) {
      observer.publish(SET, "20", false);
      // anything that the broker sends for the command comes before the next value
      robot.variables().set("$OV_PRO", "11");
      observer.await(VALUE, "\"value\":11");

      assertThat(observer.on(RESULT)).isEmpty();
    }
    assertThat(robot.variables().get("$OV_PRO")).isEqualTo("11");
  }

  @Test
  void tellsThatTheOutcomeIsUnknown() throws Exception {
    startWithCommands();
    try (Observer observer = observer(broker)) {
      robot.fault(RecordedRequest::isWrite, Fault.dropAnswer());

      observer.publish(SET, "20", false);

      observer.await(RESULT, "the outcome is unknown");
      long writes = robot.requests().stream().filter(RecordedRequest::isWrite).count();
      assertThat(writes).isEqualTo(1);
    }
  }

  @Test
  void refusesCommandsThatWouldWaitTooLong() throws Exception {
    startWithCommands();
    CountDownLatch released = new CountDownLatch(1);
    try (Observer observer = observer(broker)) {
      robot.fault(RecordedRequest::isWrite, Fault.hold(released));
      for (int i = 0; i < 30; i++) {
        observer.publish(SET, "20", false);
      }

      observer.await(RESULT, "not executed: 16 commands are waiting");
    } finally {
      released.countDown();
    }
  }
}
