package no.hials.crosscom.web.internal.socket;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;

/** Runs a command of a page. */
@FunctionalInterface
public interface Command {
  /**
   * Runs the command.
   *
   * @param call the message and its sender
   * @param answer the answer, empty at first
   * @throws IOException if the command is not done; the page shows the message
   */
  void run(Call call, ObjectNode answer) throws IOException;
}
