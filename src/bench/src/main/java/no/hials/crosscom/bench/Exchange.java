package no.hials.crosscom.bench;

import java.io.IOException;

/** One request and its answer. */
@FunctionalInterface
interface Exchange {
  /**
   * Sends the request and takes the answer.
   *
   * @return a number out of the answer
   */
  double run() throws IOException;
}
