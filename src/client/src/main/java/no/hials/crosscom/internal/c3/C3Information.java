package no.hials.crosscom.internal.c3;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.c3.BenchmarkResult;
import no.hials.crosscom.c3.BridgeInfo;
import no.hials.crosscom.c3.Information;
import no.hials.crosscom.internal.MessageChannel;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.PlainResponse;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.server.Features;
import no.hials.crosscom.protocol.server.ServerInformation;
import no.hials.crosscom.protocol.server.ServerRequest;
import no.hials.crosscom.protocol.server.ServerResponse.FeaturesResponse;
import no.hials.crosscom.protocol.server.ServerResponse.InformationResponse;
import no.hials.crosscom.protocol.variable.Assignment;
import no.hials.crosscom.protocol.variable.VariableRequest.BenchmarkReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.BenchmarkWriteRequest;
import no.hials.crosscom.protocol.variable.VariableResponse.BenchmarkResponse;

/** Asks the server by messages of types 13, 14, 17 and 63. */
public final class C3Information implements Information {
  /** The maximum number of variables in a benchmark. */
  private static final int MAX_BENCHMARK = 10;

  private final MessageChannel channel;

  public C3Information(MessageChannel channel) {
    this.channel = channel;
  }

  @Override
  public BridgeInfo get() throws CrossComException {
    ServerInformation information =
        channel
            .ask(
                new ServerRequest(0, MessageType.INFORMATION),
                InformationResponse.class,
                "request for the server's information")
            .information();
    return new BridgeInfo(
        information.version(),
        information.build(),
        information.time().instant().orElse(null),
        information.computerName());
  }

  @Override
  public Features features() throws CrossComException {
    return channel
        .ask(
            new ServerRequest(0, MessageType.FEATURES),
            FeaturesResponse.class,
            "request for the server's features")
        .features();
  }

  @Override
  public void confirmAll() throws CrossComException {
    channel.ask(
        new ServerRequest(0, MessageType.CONFIRM_ALL),
        PlainResponse.class,
        "confirmation of all messages");
  }

  @Override
  public BenchmarkResult benchmarkRead(long iterations, List<String> names)
      throws CrossComException {
    checkCount(Objects.requireNonNull(names, "names").size());
    return benchmark(
        new BenchmarkReadRequest(0, iterations, names), "benchmark of reading " + names);
  }

  @Override
  public BenchmarkResult benchmarkWrite(long iterations, Map<String, String> values)
      throws CrossComException {
    checkCount(Objects.requireNonNull(values, "values").size());
    List<Assignment> assignments = new ArrayList<>();
    values.forEach((name, value) -> assignments.add(new Assignment(name, value)));
    return benchmark(
        new BenchmarkWriteRequest(0, iterations, assignments),
        "benchmark of writing " + values.keySet());
  }

  private BenchmarkResult benchmark(Request request, String what) throws CrossComException {
    BenchmarkResponse response = channel.ask(request, BenchmarkResponse.class, what);
    return new BenchmarkResult(
        response.count(), response.iterations(), Duration.ofMillis(response.differenceMillis()));
  }

  private static void checkCount(int count) {
    if (count < 1 || count > MAX_BENCHMARK) {
      throw new IllegalArgumentException(
          "a benchmark must have 1 to " + MAX_BENCHMARK + " variables, has " + count);
    }
  }
}
