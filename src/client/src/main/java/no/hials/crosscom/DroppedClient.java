package no.hials.crosscom;

import java.lang.ref.Cleaner;
import no.hials.crosscom.ConnectionEvent.ChangeReason;
import no.hials.crosscom.internal.exchange.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Closes a client that the program has dropped without closing it. */
final class DroppedClient implements Runnable {
  private static final Logger LOG = LoggerFactory.getLogger(CrossComClient.class);

  /** Shared by all clients; null until its thread could be started. */
  private static @Nullable Cleaner cleaner;

  private final ClientConfig config;
  private final ReconnectingConnection connection;
  private final Threads threads;
  private final String place = place();

  private DroppedClient(ClientConfig config, ReconnectingConnection connection, Threads threads) {
    this.config = config;
    this.connection = connection;
    this.threads = threads;
  }

  /**
   * Closes a client when nothing refers to an object any more; never if the thread for it cannot be
   * started.
   *
   * @param object to which the client and its views refer
   * @return closes the client earlier, without a warning
   */
  static Cleaner.Cleanable register(
      Object object, ClientConfig config, ReconnectingConnection connection, Threads threads) {
    DroppedClient client = new DroppedClient(config, connection, threads);
    try {
      return cleaner().register(object, client);
    } catch (OutOfMemoryError e) {
      LOG.debug("a client will not be closed if it is dropped", e);
      return client::run;
    }
  }

  private static synchronized Cleaner cleaner() {
    Cleaner own = cleaner;
    if (own == null) {
      own = Cleaner.create();
      cleaner = own;
    }
    return own;
  }

  /** Returns the line of the program that creates the client. */
  private static String place() {
    return StackWalker.getInstance()
        .walk(frames -> frames.filter(DroppedClient::isOfTheProgram).findFirst())
        .map(StackWalker.StackFrame::toString)
        .orElse("an unknown place");
  }

  private static boolean isOfTheProgram(StackWalker.StackFrame frame) {
    return !frame.getClassName().matches(".*\\.(CrossComClient|DroppedClient)");
  }

  @Override
  public void run() {
    if (!connection.isClosed()) {
      LOG.warn(
          "a client of {}:{}, created by {}, was dropped without close(), and is closed now",
          config.host(),
          config.port(),
          place);
    }
    connection.close(ChangeReason.DROPPED);
    threads.shutdown();
  }
}
