package no.hials.crosscom.gateway;

import java.io.IOException;
import java.util.List;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Update;

/**
 * Passes values on to another system. An output never delays the readings of a robot or another
 * output: its methods do not block, and its failures do not affect them.
 */
public interface Output extends AutoCloseable {
  /**
   * Called once, when the robots of the configuration are added: from now on the other system can
   * use the output.
   *
   * @throws IOException if it cannot start; the gateway closes it then
   */
  default void ready() throws IOException {}

  /** Called before the first update of a robot. */
  void added(RobotFeed robot);

  /**
   * Called with updates of a robot. Calls for the same robot never overlap.
   *
   * @param updates at least one, of variables that were read together
   */
  void updated(RobotFeed robot, List<Update> updates);

  /** Called after the last update of a robot that was removed from the configuration. */
  void removed(RobotFeed robot);

  /**
   * Called before the gateway closes its robots: the output begins no more writes, and gives the
   * running ones a short time to end.
   */
  default void endWrites() {}

  /** Stops the output. */
  @Override
  void close();
}
