package no.hials.crosscom.cli.mock;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import no.hials.crosscom.cell.DaemonThreadFactory;
import no.hials.crosscom.cli.base.Console;
import no.hials.crosscom.cli.base.LiveLine;
import no.hials.crosscom.cli.base.MessageFeed;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.Message;

/**
 * Shows the state of a simulated controller: its messages line by line on stderr, and on a terminal
 * a last line that changes in place; there it also reads {@link OperatorKeys}. The last line goes
 * to stdout, which is then a terminal.
 */
final class StatusLine implements AutoCloseable {
  private static final long PERIOD_MILLIS = 250;

  private final Console console;
  private final MockServer server;
  private final BooleanSupplier isShown;
  private final LiveLine line;
  private final OperatorKeys keys;
  private final ScheduledExecutorService executor =
      Executors.newSingleThreadScheduledExecutor(DaemonThreadFactory.named("status-line"));

  private final MessageFeed messages;
  private boolean closed;

  /**
   * Creates a status line that shows nothing yet.
   *
   * @param isShown whether to show the line; otherwise only the messages
   */
  StatusLine(Console console, MockServer server, BooleanSupplier isShown) {
    this.console = console;
    this.server = server;
    this.isShown = isShown;
    this.line = new LiveLine(console.out(), true);
    this.messages = new MessageFeed(server.controller());
    this.keys = new OperatorKeys(console.in(), server.controller(), console::hint);
  }

  void start() {
    @SuppressWarnings("unused") // it ends with the executor
    var task = executor.scheduleWithFixedDelay(this::show, 0, PERIOD_MILLIS, TimeUnit.MILLISECONDS);
  }

  /** Shows new messages and the state. */
  synchronized void show() {
    if (closed) {
      return;
    }
    showMessages();
    if (isShown.getAsBoolean()) {
      keys.poll();
      line.show(text(server));
    }
  }

  private void showMessages() {
    List<Message> fresh = messages.poll();
    if (!fresh.isEmpty()) {
      line.clear();
      fresh.forEach(message -> console.hint(MessageFeed.text(message)));
    }
  }

  /** Returns the line: simulated time, mode and programs, axes, clients and requests. */
  static String text(MockServer server) {
    Controller controller = server.controller();
    return String.format(
        Locale.ROOT,
        "%.1f s | %s | %s deg | clients %d, requests %d",
        controller.time().toMillis() / 1000.0,
        controller,
        Arrays.stream(controller.axes().toArray())
            .mapToObj(degrees -> String.format(Locale.ROOT, "%.1f", degrees))
            .collect(Collectors.joining(" ")),
        server.clientCount(),
        server.requestCount());
  }

  /** Shows the last messages, and removes the line. */
  @Override
  public synchronized void close() {
    executor.shutdown();
    showMessages();
    line.clear();
    closed = true;
  }
}
