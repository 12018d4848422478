package no.hials.crosscom.gateway.broker;

import static org.assertj.core.api.Assertions.assertThat;

import com.hivemq.client.mqtt.datatypes.MqttQos;
import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5Publish;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Predicate;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.gateway.Gateway;
import no.hials.crosscom.gateway.GatewayContext;
import no.hials.crosscom.gateway.Health;
import no.hials.crosscom.gateway.Latches;
import no.hials.crosscom.gateway.Output;
import no.hials.crosscom.gateway.OutputKind;
import no.hials.crosscom.gateway.internal.broker.BrokerSettings;
import no.hials.crosscom.gateway.internal.broker.Publication;
import no.hials.crosscom.gateway.internal.broker.Received;
import no.hials.crosscom.gateway.internal.broker.Session;
import no.hials.crosscom.gateway.internal.mqtt.MqttKind;
import no.hials.crosscom.gateway.internal.sparkplug.SparkplugId;
import no.hials.crosscom.gateway.internal.sparkplug.SparkplugTraffic;
import no.hials.crosscom.mock.RecordedRequest;
import org.eclipse.tahu.message.SparkplugBPayloadDecoder;
import org.eclipse.tahu.message.SparkplugBPayloadEncoder;
import org.eclipse.tahu.message.model.Metric;
import org.eclipse.tahu.message.model.MetricDataType;
import org.eclipse.tahu.message.model.SparkplugBPayload;
import org.eclipse.tahu.protobuf.SparkplugBProto.Payload;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SparkplugIT extends BrokerTest {
  private static final String NODE =
      "sparkplug-group = \"hall1\"\nsparkplug-node = \"gateway1\"\nclient-id = \"gw\"\n";
  private static final String READ =
      """
      [groups.all]
      variables = ["$OV_PRO", "$POS_ACT", "$MODE_OP", "COUNTER"]
      period = "20ms"
      on-change = true

      [variables."$OV_PRO"]
      write = true
      range = [0, 100]

      """;
  private static final String NBIRTH = "spBv1.0/hall1/NBIRTH/gateway1";
  private static final String NDEATH = "spBv1.0/hall1/NDEATH/gateway1";
  private static final String DBIRTH = "spBv1.0/hall1/DBIRTH/gateway1/cell1";
  private static final String DDATA = "spBv1.0/hall1/DDATA/gateway1/cell1";
  private static final String DDEATH = "spBv1.0/hall1/DDEATH/gateway1/cell1";

  @BeforeEach
  void declareCounter() {
    robot.variables().declare("COUNTER", "INT", "0");
  }

  private static SparkplugBPayload decode(Mqtt5Publish message) {
    try {
      return new SparkplugBPayloadDecoder().buildFromByteArray(message.getPayloadAsBytes(), null);
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }

  private static Optional<Metric> metric(Mqtt5Publish message, String name) {
    return decode(message).getMetrics().stream().filter(it -> name.equals(it.getName())).findAny();
  }

  private static Metric metricOf(Mqtt5Publish birth, String name) {
    return metric(birth, name).orElseThrow();
  }

  private static boolean has(Mqtt5Publish message, long alias, Predicate<Metric> condition) {
    return decode(message).getMetrics().stream()
        .anyMatch(it -> Objects.equals(it.getAlias(), alias) && condition.test(it));
  }

  private static Mqtt5Publish last(Observer observer, String topic) {
    List<Mqtt5Publish> all = observer.on(topic);
    return all.get(all.size() - 1);
  }

  private static Mqtt5Publish awaitData(Observer observer, long alias, Predicate<Metric> condition)
      throws InterruptedException {
    Predicate<Mqtt5Publish> wanted =
        it -> it.getTopic().toString().equals(DDATA) && has(it, alias, condition);
    return observer.await(all -> all.stream().anyMatch(wanted)).stream()
        .filter(wanted)
        .findFirst()
        .orElseThrow();
  }

  private static byte[] encode(Metric metric) throws Exception {
    return new SparkplugBPayloadEncoder()
        .getBytes(
            new SparkplugBPayload.SparkplugBPayloadBuilder().addMetric(metric).createPayload(),
            false);
  }

  private static Mqtt5Publish command(String topic, Metric metric) throws Exception {
    return Mqtt5Publish.builder()
        .topic(topic)
        .payload(encode(metric))
        .qos(MqttQos.AT_LEAST_ONCE)
        .build();
  }

  private static Object quality(Metric metric) {
    return metric.getProperties().getPropertyMap().get("Quality").getValue();
  }

  @Test
  void birthsComeFirstAndDataFollowsByAlias() throws Exception {
    broker = Mosquitto.open(folder);
    try (Observer observer = new Observer(broker.port()).subscribe("spBv1.0/#")) {
      start(READ + mqtt(broker, NODE));
      Mqtt5Publish node = observer.await(NBIRTH, "");
      Mqtt5Publish device = observer.await(DBIRTH, "");

      assertThat(observer.all().subList(0, 2)).containsExactly(node, device);
      assertThat(decode(node).getSeq()).isZero();
      assertThat(metricOf(node, "bdSeq").getValue()).isEqualTo(0L);
      assertThat(metricOf(node, "Node Control/Rebirth").getValue()).isEqualTo(false);
      assertThat(metricOf(device, "$OV_PRO").getDataType()).isEqualTo(MetricDataType.Int32);
      assertThat(metricOf(device, "$OV_PRO").getValue()).isEqualTo(100);
      assertThat(metricOf(device, "$MODE_OP").getValue()).isEqualTo("#T1");
      Metric x = metricOf(device, "$POS_ACT.X");
      assertThat(x.getDataType()).isEqualTo(MetricDataType.Float);
      assertThat(x.getProperties().getPropertyMap().get("engUnit").getValue()).isEqualTo("mm");
      assertThat(quality(x)).isEqualTo(192);
      assertThat(decode(device).getMetrics()).extracting(Metric::getAlias).doesNotHaveDuplicates();

      robot.variables().set("$OV_PRO", "73");

      long alias = metricOf(device, "$OV_PRO").getAlias();
      Mqtt5Publish data = awaitData(observer, alias, it -> it.getValue().equals(73));
      assertThat(decode(data).getMetrics().get(0).getName()).isNull();
      assertThat(data.isRetain()).isFalse();
      assertThat(data.getQos()).isEqualTo(MqttQos.AT_MOST_ONCE);
    }
  }

  @Test
  void theSequenceRunsOverAllMessagesOfTheNode() throws Exception {
    broker = Mosquitto.open(folder);
    try (Observer observer = new Observer(broker.port()).subscribe("spBv1.0/#")) {
      start(READ.replace("on-change = true", "").replace("20ms", "10ms") + mqtt(broker, NODE));

      List<Mqtt5Publish> all = observer.await(it -> it.size() > 600);

      List<Long> expected = new ArrayList<>();
      for (int i = 0; i < all.size(); i++) {
        expected.add(i % 256L);
      }
      assertThat(all).extracting(it -> decode(it).getSeq()).isEqualTo(expected);
    }
  }

  @Test
  void aLostRobotDiesAndIsBornAgain() throws Exception {
    broker = Mosquitto.open(folder);
    try (Observer observer = new Observer(broker.port()).subscribe("spBv1.0/#")) {
      start(READ + mqtt(broker, NODE));
      observer.await(DBIRTH, "");

      robot.refuseConnections();
      robot.disconnectClients();

      observer.await(DDEATH, "");
      assertThat(last(observer, DDEATH)).isEqualTo(observer.all().get(observer.all().size() - 1));
      robot.variables().set("$OV_PRO", "42");
      robot.acceptConnections();

      observer.await(all -> observer.on(DBIRTH).size() == 2);
      assertThat(metricOf(last(observer, DBIRTH), "$OV_PRO").getValue()).isEqualTo(42);
    }
  }

  @Test
  void theWillHasTheNumberOfItsBirthAndStoredValuesAreHistorical() throws Exception {
    broker = Mosquitto.open(folder);
    try (Cable cable = new Cable(broker.port());
        Observer observer = new Observer(broker.port()).subscribe("spBv1.0/#")) {
      cable.connect();
      Gateway reading = start(READ + mqtt(cable, NODE));
      Mqtt5Publish birth = observer.await(DBIRTH, "");
      Object number = metricOf(last(observer, NBIRTH), "bdSeq").getValue();

      cable.cut();
      Mqtt5Publish death = observer.await(NDEATH, "");
      assertThat(metricOf(death, "bdSeq").getValue()).isEqualTo(number);
      assertThat(decode(death).getSeq())
          .satisfiesAnyOf(it -> assertThat(it).isNull(), it -> assertThat(it).isEqualTo(-1L));
      await(() -> figure(reading, "mqtt_connected") == 0);
      for (String value : List.of("1", "2", "3")) {
        robot.variables().set("COUNTER", value);
        await(() -> hasCounter(reading.robots().get(0), value));
      }
      cable.connect();

      observer.await(all -> observer.on(NBIRTH).size() == 2);
      assertThat((long) metricOf(last(observer, NBIRTH), "bdSeq").getValue())
          .isGreaterThan((long) number);
      long alias = metricOf(birth, "COUNTER").getAlias();
      for (int value : List.of(1, 2, 3)) {
        Mqtt5Publish data = awaitData(observer, alias, it -> it.getValue().equals(value));
        assertThat(has(data, alias, it -> Boolean.TRUE.equals(it.isHistorical()))).isTrue();
        assertThat(observer.all().indexOf(data))
            .isGreaterThan(observer.all().indexOf(last(observer, DBIRTH)));
      }
    }
  }

  @Test
  void theValuesOfABirthThatTheBrokerDidNotGetAreHistorical() throws Exception {
    broker = Mosquitto.open(folder);
    try (Cable cable = new Cable(broker.port());
        Observer observer = new Observer(broker.port()).subscribe("spBv1.0/#")) {
      cable.connect();
      Gateway reading = start(READ + mqtt(cable, NODE));
      long alias = metricOf(observer.await(DBIRTH, ""), "COUNTER").getAlias();
      robot.refuseConnections();
      robot.disconnectClients();
      observer.await(DDEATH, "");

      cable.hold();
      for (String value : List.of("1", "2")) {
        robot.variables().set("COUNTER", value);
        robot.acceptConnections();
        await(() -> hasCounter(reading.robots().get(0), value));
      }
      cable.cut();
      cable.connect();

      for (int value : List.of(1, 2)) {
        Mqtt5Publish data = awaitData(observer, alias, it -> it.getValue().equals(value));
        assertThat(has(data, alias, it -> Boolean.TRUE.equals(it.isHistorical()))).isTrue();
      }
    }
  }

  /** An output whose start takes until it is told to end. */
  private record SlowOutput(Runnable starting) implements OutputKind<String> {
    @Override
    public String table() {
      return "slow";
    }

    @Override
    public String read(TomlTable table) {
      return "";
    }

    @Override
    public Output open(String settings, GatewayContext context) {
      starting.run();
      return new Output() {
        @Override
        public void added(RobotFeed added) {}

        @Override
        public void updated(RobotFeed updated, List<Update> updates) {}

        @Override
        public void removed(RobotFeed removed) {}

        @Override
        public void close() {}
      };
    }
  }

  @Test
  void storedValuesWaitForTheirRobotAndThoseOfARemovedOneAreCounted() throws Exception {
    broker = Mosquitto.open(folder);
    broker.kill();
    String cell2 = "[robots.cell2]\nhost = \"%s:%d\"\n".formatted(robot.host(), robot.port());
    Gateway before = start(cell2 + READ + mqtt(broker, NODE));
    for (String value : List.of("1", "2", "3")) {
      robot.variables().set("COUNTER", value);
      await(() -> before.robots().stream().allMatch(it -> hasCounter(it, value)));
    }
    before.close();
    broker.start();
    try (Observer observer = new Observer(broker.port()).subscribe("spBv1.0/hall1/#")) {
      // after the last of these births, the session has looked for stored messages
      Runnable untilForwarding =
          () -> {
            awaitBirths(observer, 1);
            observer.publish(rebirth());
            awaitBirths(observer, 2);
            observer.publish(rebirth());
            awaitBirths(observer, 3);
          };
      Gateway after =
          start(
              READ + mqtt(broker, NODE) + "[slow]\n",
              List.of(new MqttKind(), new SlowOutput(untilForwarding)));
      await(() -> lines.get().stream().anyMatch(it -> it.contains("sparkplug: the stored")));

      long alias = metricOf(observer.await(DBIRTH, ""), "COUNTER").getAlias();
      for (int value : List.of(1, 2, 3)) {
        Mqtt5Publish data = awaitData(observer, alias, it -> it.getValue().equals(value));
        assertThat(has(data, alias, it -> Boolean.TRUE.equals(it.isHistorical()))).isTrue();
      }
      double lost = figure(after, "mqtt_messages_dropped");
      assertThat(lost).isGreaterThanOrEqualTo(3);
      assertThat(lines.get())
          .contains(
              "MQTT sparkplug: the stored messages are forwarded, but %.0f of them or of their values are lost: the robot or value is no longer there, or has another type"
                  .formatted(lost));
    }
  }

  @Test
  void storedValuesWhoseMetricHasAnotherTypeNowAreCounted() throws Exception {
    broker = Mosquitto.open(folder);
    broker.kill();
    robot.variables().declare("COUNTER", "REAL", "4.5");
    Gateway before = start(READ + mqtt(broker, NODE));
    await(() -> hasCounter(before.robots().get(0), "4.5"));
    robot.variables().set("COUNTER", "5.5");
    await(() -> hasCounter(before.robots().get(0), "5.5"));
    before.close();
    robot.variables().declare("COUNTER", "INT", "9");
    Gateway after = start(READ + mqtt(broker, NODE));
    await(() -> hasCounter(after.robots().get(0), "9"));
    broker.start();
    await(() -> lines.get().stream().anyMatch(it -> it.contains("sparkplug: the stored")));

    assertThat(figure(after, "mqtt_messages_dropped")).isEqualTo(2);
    assertThat(lines.get())
        .contains(
            "MQTT sparkplug: the stored messages are forwarded, but 2 of them or of their values are lost: the robot or value is no longer there, or has another type");
  }

  private static boolean hasCounter(RobotFeed feed, String value) {
    return feed.lastValue("COUNTER")
        .filter(it -> it.asDouble() == Double.parseDouble(value))
        .isPresent();
  }

  private static Mqtt5Publish rebirth() {
    try {
      return command(
          "spBv1.0/hall1/NCMD/gateway1",
          new Metric.MetricBuilder("Node Control/Rebirth", MetricDataType.Boolean, true)
              .createMetric());
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }

  private static void awaitBirths(Observer observer, int number) {
    try {
      observer.await(all -> observer.on(NBIRTH).size() >= number);
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void anotherApplicationCanAskForTheBirths() throws Exception {
    broker = Mosquitto.open(folder);
    try (Observer observer = new Observer(broker.port()).subscribe("spBv1.0/+/+/gateway1/#")) {
      start(READ + mqtt(broker, NODE));
      observer.await(DBIRTH, "");
      Object number = metricOf(last(observer, NBIRTH), "bdSeq").getValue();

      observer.publish(rebirth());

      observer.await(all -> observer.on(DBIRTH).size() == 2);
      assertThat(metricOf(last(observer, NBIRTH), "bdSeq").getValue()).isEqualTo(number);
      assertThat(decode(last(observer, NBIRTH)).getSeq()).isZero();
      assertThat(decode(last(observer, DBIRTH)).getSeq()).isEqualTo(1);
    }
  }

  @Test
  void requestsForBirthsThatWaitHaveOneAnswer() throws Exception {
    broker = Mosquitto.open(folder);
    BrokerSettings settings =
        new BrokerSettings("127.0.0.1", broker.port(), false, 5, "gw", null, null, null, 1_000_000);
    CountDownLatch released = new CountDownLatch(1);
    try (Observer observer = new Observer(broker.port()).subscribe("#");
        Session session = new Session(settings, "sparkplug", folder, new Health())) {
      SparkplugTraffic traffic =
          new SparkplugTraffic(
              new SparkplugId("hall1", "gateway1"),
              session,
              folder.resolve("bdseq"),
              null,
              name -> false);
      session.start(traffic);
      observer.await(NBIRTH, "");
      session.submit(0, () -> Latches.await(released));

      Received request =
          new Received(
              "spBv1.0/hall1/NCMD/gateway1",
              ByteBuffer.wrap(rebirth().getPayloadAsBytes()),
              false,
              "",
              null,
              null,
              null);
      Consumer<Received> receiver = traffic.subscriptions().get(0).receiver();
      for (int i = 0; i < 50; i++) {
        receiver.accept(request);
      }
      session.submit(0, () -> session.publish(new Publication("end", new byte[0], 0, false), null));
      released.countDown();

      observer.await("end", "");
      assertThat(observer.on(NBIRTH)).hasSize(2);
    } finally {
      released.countDown();
    }
  }

  @Test
  void aDeviceWhoseDataEndTheConnectionIsDeadMeanwhile() throws Exception {
    broker = Mosquitto.open(folder);
    robot.variables().declare("TICKS", "INT", "0");
    String read =
        """
        [robots.cell2]
        host = "%s:%d"
        [groups.all]
        variables = ["TICKS"]
        period = "50ms"
        on-change = true
        """
            .formatted(robot.host(), robot.port());
    try (Cable cable = new Cable(broker.port());
        Observer observer = new Observer(broker.port()).subscribe("spBv1.0/#")) {
      cable.endAt(DDATA);
      cable.connect();
      start(read + mqtt(cable, NODE));
      observer.await(DBIRTH, "");

      AtomicInteger ticks = new AtomicInteger();
      BooleanSupplier isBlocked =
          () -> {
            robot.variables().set("TICKS", String.valueOf(ticks.incrementAndGet()));
            LockSupport.parkNanos(20_000_000);
            return lines.get().stream().anyMatch(it -> it.contains("the broker ends the"));
          };
      await(isBlocked);
      observer.forget();
      int before = ticks.get();
      await(() -> isBlocked.getAsBoolean() && ticks.get() > before + 100);

      assertThat(observer.on(DDATA)).isEmpty();
      assertThat(observer.on(DDEATH).size()).isEqualTo(observer.on(DBIRTH).size());
      cable.endAt(null);
      await(() -> isBlocked.getAsBoolean() && !observer.on(DDATA).isEmpty());
      assertSequence(observer.all());
    }
  }

  private static void assertSequence(List<Mqtt5Publish> messages) {
    long next = -1;
    for (Mqtt5Publish message : messages) {
      String topic = message.getTopic().toString();
      if (topic.contains("/D") || topic.equals(NBIRTH)) {
        long seq = decode(message).getSeq();
        if (next >= 0 && seq != 0) {
          assertThat(seq).as("the number of %s", topic).isEqualTo(next);
        }
        next = (seq + 1) % 256;
      }
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 5})
  void afterAnErrorTheNodeDiesAndIsBornAgain(int version) throws Exception {
    broker = Mosquitto.open(folder);
    BrokerSettings settings =
        new BrokerSettings(
            "127.0.0.1", broker.port(), false, version, "gw", null, null, null, 1_000_000);
    try (Observer observer = new Observer(broker.port()).subscribe("spBv1.0/#");
        Session session = new Session(settings, "sparkplug", folder, new Health())) {
      session.start(
          new SparkplugTraffic(
              new SparkplugId("hall1", "gateway1"),
              session,
              folder.resolve("bdseq"),
              null,
              name -> false));
      observer.await(NBIRTH, "");

      session.submit(
          1,
          () -> {
            throw new OutOfMemoryError("simulated");
          });

      observer.await(all -> observer.on(NBIRTH).size() == 2);
      assertThat(observer.on(NDEATH)).hasSize(1);
      assertThat(metricOf(last(observer, NDEATH), "bdSeq").getValue()).isEqualTo(0L);
      assertThat(metricOf(last(observer, NBIRTH), "bdSeq").getValue()).isEqualTo(1L);
    }
  }

  @Test
  void otherMetricsMakeAnotherBirthAndAMissingValueIsNull() throws Exception {
    broker = Mosquitto.open(folder);
    try (Observer observer = new Observer(broker.port()).subscribe("spBv1.0/#")) {
      robot.variables().remove("COUNTER");
      start(READ + mqtt(broker, NODE));
      Mqtt5Publish first = observer.await(DBIRTH, "");
      assertThat(metric(first, "COUNTER")).isEmpty();

      robot.variables().declare("COUNTER", "INT", "5");

      observer.await(all -> observer.on(DBIRTH).size() == 2);
      Metric counter = metricOf(last(observer, DBIRTH), "COUNTER");
      assertThat(counter.getValue()).isEqualTo(5);

      robot.variables().remove("COUNTER");

      Mqtt5Publish data =
          awaitData(observer, counter.getAlias(), it -> Boolean.TRUE.equals(it.getIsNull()));
      assertThat(has(data, counter.getAlias(), it -> quality(it).equals(0))).isTrue();

      robot.variables().declare("COUNTER", "BOOL", "TRUE");

      observer.await(all -> observer.on(DBIRTH).size() == 3);
      assertThat(metricOf(last(observer, DBIRTH), "COUNTER").getDataType())
          .isEqualTo(MetricDataType.Boolean);
    }
  }

  @Test
  void aDeviceCommandWritesWhatIsAllowed() throws Exception {
    broker = Mosquitto.open(folder);
    try (Observer observer = new Observer(broker.port()).subscribe("spBv1.0/#")) {
      Gateway reading = start(READ + mqtt(broker, NODE, "commands = true"));
      Mqtt5Publish birth = observer.await(DBIRTH, "");
      String topic = "spBv1.0/hall1/DCMD/gateway1/cell1";
      long alias = metricOf(birth, "$OV_PRO").getAlias();

      observer.publish(
          command(
              topic, new Metric.MetricBuilder("COUNTER", MetricDataType.Int32, 7).createMetric()));
      observer.publish(
          command(topic, new Metric.MetricBuilder(alias, MetricDataType.Int32, 55).createMetric()));

      awaitData(observer, alias, it -> it.getValue().equals(55));
      assertThat(robot.variables().get("COUNTER")).contains("0");
      assertThat(figure(reading, "mqtt_commands")).isEqualTo(2);
    }
  }

  @Test
  void aDeviceCommandThatIsNotClearIsRefusedWithALineInTheAuditLog() throws Exception {
    broker = Mosquitto.open(folder);
    try (Observer observer = new Observer(broker.port()).subscribe("spBv1.0/#")) {
      Gateway reading = start(READ + mqtt(broker, NODE, "commands = true"));
      Mqtt5Publish birth = observer.await(DBIRTH, "");
      long other = metricOf(birth, "COUNTER").getAlias();
      for (Payload.Metric.Builder value :
          List.of(
              Payload.Metric.newBuilder().setLongValue(30),
              Payload.Metric.newBuilder(),
              Payload.Metric.newBuilder().setIntValue(31).setIsHistorical(true),
              Payload.Metric.newBuilder().setIntValue(32).setAlias(other),
              Payload.Metric.newBuilder().setIntValue(30))) {
        observer.publish(
            Mqtt5Publish.builder()
                .topic("spBv1.0/hall1/DCMD/gateway1/cell1")
                .payload(
                    Payload.newBuilder()
                        .addMetrics(value.setName("$OV_PRO").setDatatype(3))
                        .build()
                        .toByteArray())
                .build());
      }

      await(() -> figure(reading, "mqtt_commands") == 5);
      assertThat(robot.requests()).filteredOn(RecordedRequest::isWrite).hasSize(1);
      assertThat(robot.variables().get("$OV_PRO")).isEqualTo("30");
      assertThat(Files.readString(folder.resolve("data/audit.jsonl")))
          .contains(
              "\"after\":\"30\",\"result\":\"cell1: $OV_PRO was not written: a value of type Int32 must be in int_value, is 30 in long_value\"",
              "\"after\":\"\",\"result\":\"cell1: $OV_PRO was not written: a command needs a value\"",
              "\"after\":\"31\",\"result\":\"cell1: $OV_PRO was not written: is_historical must be false in a command, is true\"",
              "\"after\":\"32\",\"result\":\"cell1: COUNTER was not written: the name must be that of the alias %d, is $OV_PRO\""
                  .formatted(other));
    }
  }
}
