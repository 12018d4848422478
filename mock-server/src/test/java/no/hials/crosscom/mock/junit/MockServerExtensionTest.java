package no.hials.crosscom.mock.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;
import static org.junit.platform.testkit.engine.EventConditions.finishedWithFailure;
import static org.junit.platform.testkit.engine.TestExecutionResultConditions.instanceOf;
import static org.junit.platform.testkit.engine.TestExecutionResultConditions.message;

import java.io.IOException;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.net.ConnectException;
import java.util.Collection;
import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CyclicBarrier;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RawClient;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Disabled;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.extension.ExtensionConfigurationException;
import org.junit.jupiter.api.extension.ParameterResolutionException;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.platform.testkit.engine.EngineExecutionResults;
import org.junit.platform.testkit.engine.EngineTestKit;

/** Tests the start and end of the servers by running the classes in this file. */
class MockServerExtensionTest {
  private static final Collection<MockServer> SERVERS = new ConcurrentLinkedQueue<>();

  @BeforeEach
  @AfterEach
  void forget() {
    SERVERS.clear();
  }

  /** Keeps an IDE from running a class that fails on purpose. */
  @Disabled("run by a test of the class around it")
  @Retention(RetentionPolicy.RUNTIME)
  private @interface RunByATest {}

  private static EngineTestKit.Builder kit(Class<?> tests) {
    return EngineTestKit.engine("junit-jupiter")
        .configurationParameter("junit.jupiter.conditions.deactivate", "*DisabledCondition")
        .selectors(selectClass(tests));
  }

  private static EngineExecutionResults run(Class<?> tests) {
    return kit(tests).execute();
  }

  private static void assertSucceeds(Class<?> tests, int count) {
    run(tests).testEvents().assertStatistics(stats -> stats.started(count).succeeded(count));
  }

  private static void assertAllClosed(int count) {
    assertThat(SERVERS).hasSize(count).doesNotHaveDuplicates();
    for (MockServer server : SERVERS) {
      assertThatThrownBy(() -> new RawClient(server)).isInstanceOf(ConnectException.class);
    }
  }

  private static void assertFailsToStart(Class<?> tests, String reason) {
    run(tests)
        .allEvents()
        .assertThatEvents()
        .haveExactly(
            1,
            finishedWithFailure(
                instanceOf(ExtensionConfigurationException.class),
                message(text -> text.contains(reason))));
  }

  private static void use(MockServer server) throws IOException {
    SERVERS.add(server);
    try (RawClient client = new RawClient(server)) {
      assertThat(client.read("PING").value()).isEqualTo("PONG");
    }
  }

  // the end

  @RunByATest
  static class AllPlaces {
    @KukaController static MockServer ofClass;
    @KukaController MockServer ofTest;

    AllPlaces(@KukaController MockServer server) throws IOException {
      use(server);
    }

    @BeforeEach
    void before(@KukaController MockServer server) throws IOException {
      use(server);
      use(ofTest);
    }

    @Test
    void test(@KukaController MockServer server) throws IOException {
      use(server);
    }

    @AfterEach
    void after(@KukaController MockServer server) throws IOException {
      use(server);
      use(ofClass);
    }
  }

  @Test
  void closesTheServersOfAllPlaces() {
    assertSucceeds(AllPlaces.class, 1);
    assertAllClosed(6);
  }

  @RunByATest
  static class Failing {
    @KukaController static MockServer ofClass;
    @KukaController MockServer ofTest;

    @Test
    void test(@KukaController MockServer server) {
      SERVERS.addAll(List.of(ofClass, ofTest, server));
      throw new IllegalStateException("on purpose");
    }
  }

  @Test
  void closesTheServersOfATestThatFailed() {
    run(Failing.class).testEvents().assertStatistics(stats -> stats.failed(1));
    assertAllClosed(3);
  }

  @RunByATest
  static class ClosesItself {
    @Test
    void test(@KukaController MockServer server) {
      SERVERS.add(server);
      server.close();
    }
  }

  @Test
  void doesNotMindATestThatClosesItsServer() {
    assertSucceeds(ClosesItself.class, 1);
    assertAllClosed(1);
  }

  @RunByATest
  static class OpenUntilTheEnd {
    @KukaController static MockServer server;

    @Test
    void test() {
      SERVERS.add(server);
    }

    @Nested
    class Inside {
      @Test
      void test() throws IOException {
        try (RawClient client = new RawClient(server)) {
          client.read("PING");
        }
      }
    }

    @AfterAll
    static void after() throws IOException {
      try (RawClient client = new RawClient(server)) {
        client.read("PING");
      }
    }
  }

  @Test
  void keepsAServerOfAClassUntilItsEnd() {
    EngineExecutionResults results = run(OpenUntilTheEnd.class);
    results.allEvents().assertStatistics(stats -> stats.failed(0));
    assertAllClosed(1);
  }

  // fields and parameters

  abstract static class Base {
    @KukaController private MockServer inherited;

    @Test
    void test() throws IOException {
      use(inherited);
    }
  }

  @RunByATest
  static class Derived extends Base {
    @KukaController private MockServer inherited;

    @Test
    void ownTest() throws IOException {
      use(inherited);
    }
  }

  @Test
  void findsFieldsOfASuperclass() {
    assertSucceeds(Derived.class, 2);
    assertAllClosed(2);
  }

  @RunByATest
  static class FieldAroundANestedClass {
    @KukaController MockServer outer;

    @Nested
    class Inside {
      @RepeatedTest(2)
      void test() throws IOException {
        use(outer);
      }
    }
  }

  @Test
  void findsFieldsAroundANestedClass() {
    assertSucceeds(FieldAroundANestedClass.class, 2);
    assertAllClosed(2);
  }

  @RunByATest
  @TestInstance(TestInstance.Lifecycle.PER_CLASS)
  static class OneInstance {
    @KukaController MockServer ofTest;

    private final MockServer ofInstance;

    OneInstance(@KukaController MockServer server) {
      ofInstance = server;
    }

    @RepeatedTest(2)
    void test() throws IOException {
      use(ofTest);
      try (RawClient client = new RawClient(ofInstance)) {
        client.read("PING");
      }
    }

    @AfterAll
    void after() throws IOException {
      use(ofInstance);
    }
  }

  @Test
  void givesEachTestAServerThoughAllShareOneInstance() {
    run(OneInstance.class).allEvents().assertStatistics(stats -> stats.failed(0));
    assertAllClosed(3);
  }

  @RunByATest
  @Execution(ExecutionMode.CONCURRENT)
  static class Parallel {
    /** Blocks until both tests run at the same time. */
    static final CyclicBarrier BOTH = new CyclicBarrier(2);

    @KukaController MockServer field;

    @RepeatedTest(2)
    void test(@KukaController MockServer parameter) throws Exception {
      BOTH.await();
      field.variables().set("MYINT", String.valueOf(field.port()));
      use(field);
      use(parameter);
      BOTH.await();
      assertThat(field.variables().get("MYINT")).isEqualTo(String.valueOf(field.port()));
      assertThat(field.requestCount()).isEqualTo(1);
    }
  }

  @Test
  void givesTestsThatRunInParallelAServerEach() {
    kit(Parallel.class)
        .configurationParameter("junit.jupiter.execution.parallel.enabled", "true")
        .configurationParameter("junit.jupiter.execution.parallel.config.strategy", "fixed")
        .configurationParameter("junit.jupiter.execution.parallel.config.fixed.parallelism", "2")
        .execute()
        .testEvents()
        .assertStatistics(stats -> stats.succeeded(2));
    assertAllClosed(4);
  }

  // errors

  @RunByATest
  static class FieldOfAnotherType {
    @KukaController static String server = "";

    @Test
    void test() {}
  }

  @RunByATest
  static class FinalField {
    @KukaController final MockServer server = null;

    @Test
    void test() {}
  }

  @RunByATest
  static class WrongLatency {
    @KukaController(latency = "slow")
    MockServer server;

    @Test
    void test() {}
  }

  @RunByATest
  static class WrongFault {
    @KukaController(faults = "drop@0")
    MockServer server;

    @Test
    void test() {}
  }

  @RunByATest
  static class TooFewClients {
    @KukaController(maxClients = -1)
    MockServer server;

    @Test
    void test() {}
  }

  @Test
  void saysWhatIsWrongWithAField() {
    assertFailsToStart(
        FieldOfAnotherType.class,
        "@KukaController needs the type MockServer, but FieldOfAnotherType.server is a"
            + " java.lang.String");
    assertFailsToStart(FinalField.class, "FinalField.server must not be final");
    assertFailsToStart(WrongLatency.class, "WrongLatency.server: latency must be none, krc4");
    assertFailsToStart(WrongFault.class, "WrongFault.server: fault 'drop@0', column 6: expected");
    assertFailsToStart(TooFewClients.class, "TooFewClients.server: maxClients must be 0 to");
  }

  @RunByATest
  static class ParameterOfAnotherType {
    @Test
    void test(@KukaController int server) {}
  }

  @Test
  void saysWhatIsWrongWithAParameter() {
    run(ParameterOfAnotherType.class)
        .testEvents()
        .assertThatEvents()
        .haveExactly(
            1,
            finishedWithFailure(
                instanceOf(ParameterResolutionException.class),
                message(
                    text ->
                        text.contains(
                            "@KukaController needs the type MockServer, but test(server) is a"
                                + " int"))));
  }
}
