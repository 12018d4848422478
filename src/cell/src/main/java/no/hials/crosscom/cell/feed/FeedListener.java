package no.hials.crosscom.cell.feed;

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
}
