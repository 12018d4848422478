package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.MockServerConfig;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Version;
import no.hials.crosscom.protocol.value.KrlInt;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Meets another server on each connection: an older one, or a KUKAVARPROXY. */
class ChangingServerTest {
  @KukaController(server = ServerType.C3_BRIDGE)
  private MockServer first;

  private Between between;
  private CrossComClient client;

  @BeforeEach
  void connect() throws Exception {
    between = new Between(first);
    client =
        new CrossComClient(
            ClientConfig.create(
                between.host(),
                cfg ->
                    cfg.port(between.port())
                        .requestTimeout(Duration.ofSeconds(60))
                        .keepAlive(Duration.ZERO)));
    client.getServer();
  }

  @AfterEach
  void disconnect() throws Exception {
    client.close();
    between.close();
  }

  /** A server that cannot read or write several variables, or does it wrong. */
  static Stream<Consumer<MockServerConfig.Builder>> lessAble() {
    return Stream.of(
        cfg -> cfg.server(ServerType.KUKAVARPROXY),
        cfg -> cfg.server(ServerType.C3_BRIDGE).version(new Version(1, 0, 0)),
        cfg -> cfg.server(ServerType.C3_BRIDGE).version(new Version(1, 1, 2)));
  }

  private static List<KRLVariable> ints(int count) {
    List<KRLVariable> variables = new ArrayList<>();
    IntStream.range(0, count)
        .forEach(i -> variables.add(new KRLInt("MYINTS[" + (i % 10 + 1) + "]")));
    variables.forEach(v -> ((KRLInt) v).setValue(7));
    return variables;
  }

  private static List<MessageType> types(MockServer server) {
    return server.requests().stream().map(r -> r.request().type()).toList();
  }

  @ParameterizedTest
  @MethodSource("lessAble")
  void aReadOfSeveralThatIsRepeatedAsksTheNewServerAsThatCan(
      Consumer<MockServerConfig.Builder> settings) throws Exception {
    try (MockServer second = MockServer.start(settings)) {
      second.variables().set("MYINTS[2]", "42");
      between.changeTo(second, type -> type == MessageType.READ_MULTIPLE.code());
      List<KRLVariable> variables = ints(10);

      assertThat(client.readVariables(variables)).hasSize(10).allMatch(VariableResult::isOk);

      assertThat(variables.get(1).getValue()).isEqualTo(42);
      assertThat(types(second)).containsOnly(MessageType.READ);
      assertThat(second.requests()).filteredOn(r -> r.name().startsWith("MYINTS")).hasSize(10);
    }
  }

  @ParameterizedTest
  @MethodSource("lessAble")
  void theMessagesBehindALostOneAreSentAsTheNewServerCan(
      Consumer<MockServerConfig.Builder> settings) throws Exception {
    try (MockServer second = MockServer.start(settings)) {
      int[] count = {0};
      between.changeTo(second, type -> type == MessageType.READ_MULTIPLE.code() && ++count[0] == 2);

      assertThat(client.readVariables(ints(511))).hasSize(511).allMatch(VariableResult::isOk);

      assertThat(types(first)).containsOnlyOnce(MessageType.READ_MULTIPLE);
      assertThat(types(second)).containsOnly(MessageType.READ);
      assertThat(second.requests()).filteredOn(r -> r.name().startsWith("MYINTS")).hasSize(256);
    }
  }

  @ParameterizedTest
  @MethodSource("lessAble")
  void aWatchGoesOnAsTheNewServerCan(Consumer<MockServerConfig.Builder> settings) throws Exception {
    BlockingQueue<Sample> samples = new LinkedBlockingQueue<>();
    try (MockServer second = MockServer.start(settings);
        Watch watch = client.watch(Duration.ofMillis(5), samples::add, "MYINT", "MYINTS[2]")) {
      assertThat(samples.take().value("MYINTS[2]")).isEqualTo(new KrlInt(0));
      second.variables().set("MYINTS[2]", "42");
      between.changeTo(second, type -> type == MessageType.READ_MULTIPLE.code());
      while (types(second).size() < 10) {
        assertThat(samples.take().value("MYINTS[2]")).isIn(new KrlInt(0), new KrlInt(42));
      }

      assertThat(types(second)).containsOnly(MessageType.READ);
      assertThat(watch.failedPolls()).isZero();
    }
  }

  @ParameterizedTest
  @MethodSource("lessAble")
  void aWriteOfSeveralIsNotRepeatedOnAnyServer(Consumer<MockServerConfig.Builder> settings)
      throws Exception {
    try (MockServer second = MockServer.start(settings)) {
      between.changeTo(second, type -> type == MessageType.WRITE_MULTIPLE.code());
      List<VariableResult> results = client.writeVariables(ints(3));

      assertThat(results)
          .extracting(VariableResult::failure)
          .hasOnlyElementsOfType(CrossComConnectionLostException.class)
          .allMatch(CrossComException::isOutcomeUnknown);
      assertThat(second.requests()).isEmpty();

      assertThat(client.writeVariables(ints(3))).allMatch(VariableResult::isOk);
      assertThat(types(second)).containsOnly(MessageType.READ, MessageType.WRITE);
    }
  }

  @Test
  void aTextWithAQuestionMarkHoldsIfTheNewServerCannotGiveItInUtf16() throws Exception {
    first.variables().set("MYSTRING[]", "\"ready?\"");
    try (MockServer second = MockServer.start(cfg -> cfg.server(ServerType.KUKAVARPROXY))) {
      second.variables().set("MYSTRING[]", "\"ready?\"");
      between.changeTo(second, type -> type == MessageType.READ_UTF16.code());

      assertThat(client.readText("MYSTRING[]")).isEqualTo("\"ready?\"");
    }
  }

  @Test
  void aCommandIsNotSentToAServerThatCameMeanwhile() throws Exception {
    try (MockServer second = MockServer.start(cfg -> cfg.server(ServerType.KUKAVARPROXY))) {
      between.changeTo(second, type -> type == MessageType.CONFIRM_ALL.code());

      assertThat(catching(() -> client.information().confirmAll()))
          .isInstanceOf(CrossComConnectionLostException.class);
      assertThat(catching(() -> client.information().confirmAll()))
          .isInstanceOf(CrossComUnsupportedException.class);
      assertThat(types(second)).containsOnly(MessageType.READ);
    }
  }

  /** Does something that fails. */
  @FunctionalInterface
  interface Failing {
    void run() throws Exception;
  }

  private static Throwable catching(Failing action) {
    try {
      action.run();
    } catch (Exception e) {
      return e;
    }
    throw new AssertionError("it did not fail");
  }
}
