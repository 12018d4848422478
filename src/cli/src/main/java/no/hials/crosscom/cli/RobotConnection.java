package no.hials.crosscom.cli;

import java.io.Closeable;
import java.io.IOException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.mock.MockServer;
import org.jspecify.annotations.Nullable;

/**
 * A connection to a controller that the user chose.
 *
 * @param target which one it is
 * @param client talks to it
 * @param simulation the controller itself if it is a simulated one
 */
record RobotConnection(Robot target, CrossComClient client, @Nullable MockServer simulation)
    implements Closeable {
  @Override
  public void close() throws IOException {
    try {
      client.close();
    } finally {
      if (simulation != null) {
        simulation.close();
      }
    }
  }
}
