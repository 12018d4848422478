package no.hials.crosscom.cell.feed;

import java.time.Duration;
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
   * Called when a period was read, before the updates of the reading. Must not block.
   *
   * @param time when the reading began
   * @param missed the readings of the period that were left out before it
   * @param failed whether no variable could be read, as without a connection
   */
  default void read(RobotFeed feed, Duration period, Instant time, long missed, boolean failed) {}
}
