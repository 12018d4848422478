package no.hials.crosscom.cell.feed;

import java.util.List;

/** Takes the updates of robots. */
@FunctionalInterface
public interface FeedListener {
  /**
   * Called with updates of one robot, at most once at a time for each. It must not block.
   *
   * @param updates at least one, of variables that were read together
   */
  void updated(RobotFeed feed, List<Update> updates);
}
