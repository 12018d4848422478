package no.hials.crosscom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.mock.MockServer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Checks that equal accesses are compared, and the programs outside JMH. */
class ComparisonTest {
  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
  private final PrintStream out = new PrintStream(bytes, true, StandardCharsets.UTF_8);

  private List<String> printed() {
    return bytes.toString(StandardCharsets.UTF_8).lines().toList();
  }

  @ParameterizedTest
  @EnumSource
  void theClientSendsTheBytesThatTheBareSocketSends(Operation operation) throws IOException {
    try (MockServer robot = MockServer.start()) {
      Operation.declare(robot.variables());
      try (CrossComClient client = new CrossComClient(robot.host(), robot.port());
          BareClient bare = new BareClient(robot.port(), operation)) {
        operation.through(client).run();
        bare.run();

        assertThat(robot.requests()).hasSize(2);
        assertThat(robot.requests().get(0).request()).isEqualTo(robot.requests().get(1).request());
      }
    }
  }

  @ParameterizedTest
  @EnumSource
  void theBareServerAnswersAsTheMockServerDoes(Operation operation) throws IOException {
    try (MockServer robot = MockServer.start();
        BareServer fixed = new BareServer(operation)) {
      Operation.declare(robot.variables());
      try (BareClient toMock = new BareClient(robot.port(), operation);
          BareClient toFixed = new BareClient(fixed.port(), operation)) {
        toMock.run();
        toFixed.run();

        assertThat(toFixed.answer()).isEqualTo(toMock.answer());
      }
    }
  }

  @ParameterizedTest
  @EnumSource
  void aRequestOfTheClientComesInOnePiece(Operation operation) throws IOException {
    ExchangeLoop.run(true, operation, 100, out);

    assertThat(printed()).containsExactly("100 requests came in 100 pieces");
  }

  @Test
  void aReReadMakesNoMoreThan64BytesOfObjects() throws IOException {
    for (Operation operation : List.of(Operation.READ_INT, Operation.READ_E6AXIS)) {
      try (BareServer server = new BareServer(operation);
          CrossComClient client = new CrossComClient("127.0.0.1", server.port())) {
        Exchange read = operation.through(client);
        RatioBenchmark.allocated(
            read, 10_000); // until all of it is compiled, escape analysis removes fewer objects

        assertThat(RatioBenchmark.allocated(read, 10_000))
            .as(operation.name())
            .isLessThanOrEqualTo(64);
      }
    }
  }

  @Test
  void theComparisonReportsEachOperationAndTheControl() throws IOException {
    new RatioBenchmark(out, 1, 2).run();

    assertThat(printed()).hasSize(2 + Operation.values().length + 2);
    for (Operation operation : Operation.values()) {
      assertThat(printed()).anyMatch(line -> line.startsWith(operation.name() + " "));
    }
    assertThat(printed()).anyMatch(line -> line.startsWith("socket twice "));
    assertThat(printed()).anyMatch(line -> line.startsWith("C3 Bridge, 10 INT: together "));
  }

  @Test
  void theRatioIsThatOfTheMedians() {
    RatioBenchmark.Result result =
        RatioBenchmark.evaluate(
            Arrays.asList(new double[] {2, 2, 100}, new double[] {4, 4, 4}),
            Arrays.asList(new double[] {1, 1, 1}, new double[] {2, 2, 500}));

    assertThat(result.one()).isEqualTo(4);
    assertThat(result.other()).isEqualTo(1.5);
    assertThat(result.minimum()).isEqualTo(2);
    assertThat(result.maximum()).isEqualTo(2);
  }

  @Test
  void theLoadOnTheMockServerIsServed() throws IOException {
    MockLoad load = new MockLoad(out);
    load.idle(20);
    load.throughput(1, 10);
    load.soak(64, 2);

    assertThat(printed()).hasSize(1 + Operation.values().length + 2);
    assertThat(printed().get(0)).startsWith("20 idle connections: ");
    assertThat(printed().get(5)).startsWith("soak: 32 requests, ");
    assertThat(printed().get(6)).startsWith("soak: 64 requests, ");
  }
}
