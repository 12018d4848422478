package no.hials.crosscom.examples;

import java.io.Closeable;
import java.io.IOException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.mock.MockServer;
import org.jspecify.annotations.Nullable;

/** Connects an example to the controller on its command line, or to a simulated controller. */
final class ExampleConnection implements Closeable {
  private final @Nullable MockServer mock;
  private final CrossComClient client;

  private ExampleConnection(@Nullable MockServer mock, CrossComClient client) {
    this.mock = mock;
    this.client = client;
  }

  /**
   * Connects.
   *
   * @param args {@code HOST PORT}, or nothing for a simulated controller
   */
  static ExampleConnection of(String[] args) throws IOException {
    if (Arguments.nameAController(args)) {
      return new ExampleConnection(null, new CrossComClient(args[0], Integer.parseInt(args[1])));
    }
    MockServer mock = MockServer.start();
    return new ExampleConnection(mock, new CrossComClient(mock.host(), mock.port()));
  }

  CrossComClient client() {
    return client;
  }

  @Override
  public void close() throws IOException {
    client.close();
    if (mock != null) {
      mock.close();
    }
  }
}
