package no.hials.crosscom.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.lang.reflect.Method;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.protocol.MalformedFrameException;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;

/** Runs every benchmark method once, and checks its result. */
class BenchmarksTest {
  private static final double[] AXES = {
    5.12345695,
    -90.1234589,
    91.2345657,
    0.00512345601,
    -45.6789436,
    123.456787,
    1250.5,
    0,
    0,
    0,
    0,
    0
  };

  @Test
  void jmhFindsEveryBenchmarkMethod() throws IOException {
    List<String> methods = new ArrayList<>();
    for (Class<?> type : List.of(ExchangeBenchmark.class, TextBenchmark.class)) {
      for (Method method : type.getMethods()) {
        if (method.isAnnotationPresent(Benchmark.class)) {
          methods.add(type.getName() + " " + method.getName());
        }
      }
    }
    try (InputStream list = BenchmarksTest.class.getResourceAsStream("/META-INF/BenchmarkList")) {
      assertThat(list).as("the list from JMH's annotation processor").isNotNull();
      String text = new String(list.readAllBytes(), StandardCharsets.UTF_8);
      // a line: JMH S 37 class S 51 generated class S 6 method ...
      assertThat(methods)
          .hasSize(8)
          .allSatisfy(
              method -> {
                String[] parts = method.split(" ", -1);
                assertThat(text.lines())
                    .anyMatch(
                        line -> line.contains(parts[0] + " ") && line.contains(" " + parts[1]));
              });
    }
  }

  static Stream<String[]> exchanges() throws NoSuchFieldException {
    String[] operations =
        ExchangeBenchmark.class.getField("operation").getAnnotation(Param.class).value();
    String[] servers =
        ExchangeBenchmark.class.getField("server").getAnnotation(Param.class).value();
    assertThat(operations)
        .containsExactly(Arrays.stream(Operation.values()).map(Enum::name).toArray(String[]::new));
    return Arrays.stream(operations)
        .flatMap(
            operation -> Arrays.stream(servers).map(server -> new String[] {operation, server}));
  }

  @ParameterizedTest(name = "{0} from the {1} server")
  @MethodSource("exchanges")
  void anExchangeGivesTheRightNumber(String operation, String server) throws IOException {
    ExchangeBenchmark benchmark = new ExchangeBenchmark();
    benchmark.operation = operation;
    benchmark.server = server;
    benchmark.open();
    try {
      assertThat(benchmark.client())
          .isCloseTo(Operation.valueOf(operation).expected(), within(1e-6));
      assertThat(benchmark.socket()).as("the flag for success").isEqualTo(1);
    } finally {
      benchmark.close();
    }
  }

  @Test
  void parsingGivesTheAxes() throws MalformedFrameException {
    TextBenchmark benchmark = text();

    assertThat(benchmark.scanIntoArray()).containsExactly(AXES);
    KRLE6Axis axes = benchmark.scanIntoE6Axis();
    assertThat(axes.asArray()).containsExactly(AXES);
    KrlValue tree = benchmark.parseTree();
    assertThat(((KrlStruct) tree).fields()).hasSize(12);
  }

  @Test
  void printingGivesTheAxes() throws MalformedFrameException {
    TextBenchmark benchmark = text();

    assertThat(benchmark.printTreeAsKrc4()).isEqualTo(Operation.AXES_READ);
    assertThat(benchmark.printTreeShortest()).isEqualTo(Operation.AXES_WRITTEN);
    assertThat(benchmark.printE6Axis()).isEqualTo(Operation.AXES_WRITTEN);
  }

  private static TextBenchmark text() throws MalformedFrameException {
    TextBenchmark benchmark = new TextBenchmark();
    benchmark.open();
    return benchmark;
  }
}
