package no.hials.crosscom.bench;

import java.io.Closeable;
import java.io.IOException;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.mock.MockServer;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/** Measures an exchange, through the client and with a bare socket. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class ExchangeBenchmark {
  /** The name of the operation. */
  @Param({"READ_INT", "READ_E6AXIS", "WRITE_INT", "WRITE_E6AXIS"})
  public String operation = "READ_INT";

  /** The server: {@code bare} answers fixed bytes, {@code mock} is the mock server. */
  @Param({"bare", "mock"})
  public String server = "bare";

  private Closeable running = () -> {};
  private Closeable connected = () -> {};
  private Closeable bareConnected = () -> {};
  private Exchange typed = () -> Double.NaN;
  private Exchange bare = () -> Double.NaN;

  /** Creates the benchmark; JMH sets its parameters. */
  public ExchangeBenchmark() {}

  /**
   * Starts the server and connects.
   *
   * @throws IOException if the connection fails
   */
  @Setup
  public void open() throws IOException {
    Operation measured = Operation.valueOf(operation);
    int port;
    if (server.equals("mock")) {
      MockServer robot = MockServer.start();
      running = robot::close;
      Operation.declare(robot.variables());
      port = robot.port();
    } else {
      BareServer fixed = new BareServer(measured);
      running = fixed;
      port = fixed.port();
    }
    CrossComClient client = new CrossComClient("127.0.0.1", port);
    connected = client;
    typed = measured.through(client);
    BareClient bareClient = new BareClient(port, measured);
    bareConnected = bareClient;
    bare = bareClient;
  }

  /**
   * Closes the connections and the server.
   *
   * @throws IOException if closing fails
   */
  @TearDown
  public void close() throws IOException {
    connected.close();
    bareConnected.close();
    running.close();
  }

  /**
   * Runs an exchange through the client.
   *
   * @return the number read, or the first axis
   * @throws IOException if the exchange fails
   */
  @Benchmark
  public double client() throws IOException {
    return typed.run();
  }

  /**
   * Runs an exchange with a socket that sends the same bytes and checks nothing.
   *
   * @return the last byte of the answer
   * @throws IOException if the exchange fails
   */
  @Benchmark
  public double socket() throws IOException {
    return bare.run();
  }
}
