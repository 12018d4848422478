package no.hials.crosscom.gateway.broker;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Brokers that accept only small packets, or few messages at a time. */
class SmallPacketsIT extends BrokerTest {
  private void limitPackets(int bytes) throws Exception {
    broker = new Mosquitto(folder, "allow_anonymous true\nmax_packet_size " + bytes);
  }

  @ParameterizedTest
  @CsvSource({
    "3, the broker ends the connection when it gets robots/cell1/$POS_ACT",
    "5, the broker refuses robots/cell1/$POS_ACT: it has "
  })
  void aMessageThatIsTooLargeDoesNotStopTheOthers(int version, String line) throws Exception {
    limitPackets(200);
    // only one that is too large: each takes 10 s to find
    String read = READ_ALL.replace(", \"NOSUCH\"", "");
    start(read + mqtt(broker, "version = " + version));
    await(() -> lines.get().stream().anyMatch(it -> it.contains(line)));
    try (Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
      observer.await("robots/cell1/$MODE_OP", "good");

      robot.variables().set("$OV_PRO", "73");

      observer.await("robots/cell1/$OV_PRO", "73");
      assertThat(observer.on("robots/cell1/$POS_ACT")).isEmpty();
    }
  }

  @Test
  void aTopicWhoseMessagesAreSometimesTooLargeKeepsTheConnection() throws Exception {
    limitPackets(150);
    robot.variables().declare("TEXT[80]", "CHAR", "\"\"");
    String read = "[groups.all]\nvariables = [\"TEXT[]\"]\nperiod = \"50ms\"\n";
    start(read + mqtt(broker));
    try (Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
      for (int i = 0; i < 5; i++) {
        double before = figure(gateway, "mqtt_messages_dropped");
        robot.variables().set("TEXT[]", '"' + "x".repeat(80) + '"');
        await(() -> figure(gateway, "mqtt_messages_dropped") > before);

        robot.variables().set("TEXT[]", "\"short" + i + '"');
        observer.await("robots/cell1/TEXT[]", "short" + i);
      }
    }
    assertThat(lines.get())
        .anyMatch(it -> it.contains("refuses robots/cell1/TEXT[]: it has "))
        .noneMatch(it -> it.contains("is lost"));
  }

  @ParameterizedTest
  @CsvSource({"3, the broker ends the connection when it gets", "5, the broker refuses"})
  void aDeviceWhoseBirthIsTooLargeIsNotBorn(int version, String line) throws Exception {
    limitPackets(400);
    start(
        READ_ALL
            + mqtt(
                broker,
                "version = " + version,
                "sparkplug-group = \"g\"",
                "sparkplug-node = \"n\""));
    try (Observer observer = new Observer(broker.port()).subscribe("spBv1.0/#")) {
      await(
          () ->
              lines.get().stream().anyMatch(it -> it.contains(line + " spBv1.0/g/DBIRTH/n/cell1")));
      observer.forget();
      double before = figure(gateway, "mqtt_messages_dropped");
      await(() -> figure(gateway, "mqtt_messages_dropped") > before + 5);

      assertThat(observer.all()).noneMatch(it -> it.getTopic().toString().contains("cell1"));
    }
  }

  @Test
  void aDeviceWhoseNextBirthIsTooLargeDies() throws Exception {
    limitPackets(400);
    String read = "[groups.all]\nvariables = [\"$OV_PRO\", \"LATE\"]\nperiod = \"50ms\"\n";
    start(read + mqtt(broker, "sparkplug-group = \"g\"", "sparkplug-node = \"n\""));
    try (Observer observer = new Observer(broker.port()).subscribe("spBv1.0/#")) {
      observer.await(
          all -> all.stream().anyMatch(it -> it.getTopic().toString().contains("DBIRTH")));

      robot.variables().declare("LATE", "E6POS", "{X 1,Y 2,Z 3,A 4,B 5,C 6,S 1,T 1,E1 0,E2 0}");

      observer.await(
          all -> all.stream().anyMatch(it -> it.getTopic().toString().contains("DDEATH")));
    }
  }

  @Test
  void aStoredMessageThatIsTooLargeIsTheOnlyOneThatIsLost() throws Exception {
    limitPackets(150);
    robot.variables().declare("TEXT[80]", "CHAR", "\"\"");
    String read = "[groups.all]\nvariables = [\"TEXT[]\"]\nperiod = \"50ms\"\non-change = true\n";
    start(read + mqtt(broker, "version = 3"));
    try (Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
      observer.await("robots/cell1/TEXT[]", "good");
      broker.kill();
      await(() -> figure(gateway, "mqtt_connected") == 0);
      for (String text : new String[] {"first", "x".repeat(80), "last"}) {
        double before = figure(gateway, "mqtt_messages_stored");
        robot.variables().set("TEXT[]", '"' + text + '"');
        await(() -> figure(gateway, "mqtt_messages_stored") > before);
      }
    }

    broker.start();
    try (Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
      await(() -> figure(gateway, "mqtt_messages_dropped") > 0);
      await(() -> figure(gateway, "mqtt_store_messages") == 0);

      robot.variables().set("TEXT[]", "\"again\"");
      observer.await("robots/cell1/TEXT[]", "again");
      assertThat(figure(gateway, "mqtt_messages_dropped")).isEqualTo(1);
    }
  }

  @Test
  void aBrokerGetsNoMoreMessagesWithQos2ThanItTakesAtATime() throws Exception {
    broker = Mosquitto.open(folder);
    String names =
        IntStream.range(0, 100)
            .mapToObj(
                i -> {
                  robot.variables().declare("COUNT" + i, "INT", "0");
                  return "\"COUNT" + i + '"';
                })
            .collect(Collectors.joining(","));
    start(
        "[groups.all]\nvariables = ["
            + names
            + "]\nperiod = \"500ms\"\n"
            + mqtt(broker, "version = 3", "qos = 2"));
    try (Observer observer = new Observer(broker.port()).subscribe("robots/#")) {
      observer.await("robots/cell1/COUNT99", "good");
      await(() -> figure(gateway, "mqtt_messages_published") > 300);
    }
    assertThat(lines.get()).noneMatch(it -> it.contains("is lost"));
  }
}
