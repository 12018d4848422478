package no.hials.crosscom.gateway.broker;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Assumptions;

/** Debian's broker on a free port of the loopback address. It loses its messages when it ends. */
final class Mosquitto implements AutoCloseable {
  private static final Path PROGRAM = Path.of("/usr/sbin/mosquitto");
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  private final Path config;
  private final int port;
  private @Nullable Process process;

  /**
   * Starts a broker, or skips the test if it is not installed.
   *
   * @param settings lines of its configuration, for its listener
   */
  Mosquitto(Path folder, String settings) throws IOException, InterruptedException {
    if (!Files.isExecutable(PROGRAM)) {
      System.out.println("skipped: " + PROGRAM + " is not installed (apt install mosquitto)");
      Assumptions.abort("mosquitto is not installed");
    }
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      port = socket.getLocalPort();
    }
    config = folder.resolve("mosquitto.conf");
    Files.writeString(
        config, "listener " + port + " 127.0.0.1\nmax_queued_messages 0\n" + settings + "\n");
    start();
  }

  /** Starts a broker that everybody may use. */
  static Mosquitto open(Path folder) throws IOException, InterruptedException {
    return new Mosquitto(folder, "allow_anonymous true");
  }

  int port() {
    return port;
  }

  /** Starts the broker again, on the same port. */
  void start() throws IOException, InterruptedException {
    Process started =
        new ProcessBuilder(PROGRAM.toString(), "-c", config.toString())
            .redirectErrorStream(true)
            .redirectOutput(config.resolveSibling("mosquitto.log").toFile())
            .start();
    process = started;
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!listens()) {
      if (!started.isAlive() || System.nanoTime() - end > 0) {
        throw new IOException(Files.readString(config.resolveSibling("mosquitto.log")));
      }
      boolean unused = started.waitFor(20, TimeUnit.MILLISECONDS);
    }
  }

  private boolean listens() {
    try (Socket socket = new Socket()) {
      socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  /** Kills the broker without disconnecting its clients first. */
  void kill() {
    close();
  }

  @Override
  public void close() {
    Process running = process;
    if (running != null) {
      running.destroyForcibly().onExit().join();
    }
  }
}
