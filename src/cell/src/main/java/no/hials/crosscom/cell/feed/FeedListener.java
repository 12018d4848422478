package no.hials.crosscom.cell.feed;

import java.time.Instant;
import java.util.List;

/** Receives the updates of robots. */
@FunctionalInterface
public interface FeedListener {
  /**
   * Called with updates of one robot; calls for the same robot never overlap. Must not block.
   *
   * @param updates the updates of variables that were read together, at least one
   */
  void updated(RobotFeed feed, List<Update> updates);

  /**
   * Called when readings of one period were left out, before the updates of the reading after them.
   * Must not block.
   *
   * @param number how many
   * @param from the time of the reading before them
   * @param to the time of the reading after them
   */
  default void missed(RobotFeed feed, long number, Instant from, Instant to) {}
}
