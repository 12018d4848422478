package no.hials.crosscom.cli;

import java.util.List;
import java.util.Locale;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.mock.Controller;
import no.hials.crosscom.mock.Message;
import no.hials.crosscom.mock.MockServer;

/**
 * Shows what a simulated controller does: its messages line by line, and on a terminal a line that
 * changes in place. Both go to stderr.
 */
final class StatusLine implements AutoCloseable {
  private static final long PERIOD_MILLIS = 250;

  /** Goes to the beginning of the line and clears it. */
  private static final String CLEAR = "\r\u001b[K";

  private final Console console;
  private final MockServer server;
  private final boolean terminal = Terminal.isInteractive();
  private final ScheduledExecutorService executor =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread thread = new Thread(task, "status-line");
            thread.setDaemon(true);
            return thread;
          });
  private int messagesShown;

  StatusLine(Console console, MockServer server) {
    this.console = console;
    this.server = server;
  }

  void start() {
    @SuppressWarnings("unused") // it ends with the executor
    var task = executor.scheduleWithFixedDelay(this::show, 0, PERIOD_MILLIS, TimeUnit.MILLISECONDS);
  }

  private void show() {
    Controller controller = server.controller();
    List<Message> messages = controller.messages();
    for (Message message :
        messages.subList(Math.min(messagesShown, messages.size()), messages.size())) {
      console.err().println((terminal ? CLEAR : "") + message);
    }
    messagesShown = messages.size();
    if (terminal) {
      console.err().print(CLEAR + text(server));
      console.err().flush();
    }
  }

  /** Gives the line: mode and programs, axes, simulated time, clients and requests. */
  static String text(MockServer server) {
    Controller controller = server.controller();
    Axes axes = controller.axes();
    StringBuilder line = new StringBuilder(controller.toString()).append(" |");
    for (int i = 0; i < axes.toArray().length; i++) {
      line.append(String.format(Locale.ROOT, " A%d %.1f", i + 1, axes.get(i)));
    }
    line.append(
        String.format(
            Locale.ROOT,
            " | %.1f s | %d clients, %d requests",
            controller.time().toMillis() / 1000.0,
            server.clientCount(),
            server.requestCount()));
    return line.toString();
  }

  @Override
  public void close() {
    executor.shutdownNow();
    try {
      // nothing is printed behind this
      if (executor.awaitTermination(1, TimeUnit.SECONDS) && terminal) {
        console.err().print(CLEAR);
        console.err().flush();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
