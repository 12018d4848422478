package no.hials.crosscom.cli.mock;

import java.io.IOException;
import java.io.Reader;
import java.util.function.Consumer;
import no.hials.crosscom.simulator.Controller;

/**
 * Reads the terminal of a simulated controller: the number of a key answers the oldest dialogue, an
 * empty line confirms the messages. It never waits for input, because a background job that reads
 * is stopped.
 */
final class OperatorKeys {
  private final Reader in;
  private final Controller controller;
  private final Consumer<String> hints;
  private final StringBuilder line = new StringBuilder();

  /**
   * @param hints gets a line if the typed one was wrong or has confirmed messages
   */
  OperatorKeys(Reader in, Controller controller, Consumer<String> hints) {
    this.in = in;
    this.controller = controller;
    this.hints = hints;
  }

  /** Executes the lines that were typed since the last call. */
  void poll() {
    try {
      while (in.ready()) {
        int next = in.read();
        if (next < 0) {
          return;
        }
        if (next == '\n') {
          execute(line.toString().strip());
          line.setLength(0);
        } else {
          line.append((char) next);
        }
      }
    } catch (IOException e) {
      line.setLength(0); // no keys without a terminal; the messages are printed anyway
    }
  }

  private void execute(String typed) {
    if (typed.isEmpty()) {
      hints.accept("confirmed messages: " + controller.confirmAll());
      return;
    }
    try {
      controller.answer(Integer.parseInt(typed));
    } catch (NumberFormatException e) {
      hints.accept("type the number of a key, or only Enter to confirm; was '" + typed + "'");
    } catch (IllegalStateException | IllegalArgumentException e) {
      hints.accept(String.valueOf(e.getMessage()));
    }
  }
}
