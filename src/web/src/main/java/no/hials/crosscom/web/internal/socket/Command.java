package no.hials.crosscom.web.internal.socket;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;

/** Does what a page asks for. */
@FunctionalInterface
public interface Command {
  /**
   * Does the work.
   *
   * @param call the message and its sender
   * @param answer the answer, empty at first
   * @throws IOException if it is not done; the page shows the message
   */
  void run(Call call, ObjectNode answer) throws IOException;
}
