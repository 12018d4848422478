package no.hials.crosscom.bench;

import java.io.IOException;

/** A request and its answer. */
@FunctionalInterface
interface Exchange {
  /**
   * Sends the request and reads the answer.
   *
   * @return a number from the answer
   */
  double run() throws IOException;
}
