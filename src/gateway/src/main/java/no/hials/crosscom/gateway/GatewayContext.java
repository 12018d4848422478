package no.hials.crosscom.gateway;

import java.nio.file.Path;
import no.hials.crosscom.cell.feed.Plant;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Writes;
import org.jspecify.annotations.Nullable;

/** The parts of the gateway that outputs use. Thread-safe. */
public interface GatewayContext {
  /** Returns the plant as currently configured. */
  Plant plant();

  /** Returns the robot of this name, or null. */
  @Nullable RobotFeed robot(String name);

  /**
   * Returns the writer for other systems. A write blocks: do not write on the thread of an update.
   */
  Writes writes();

  /** Returns the folder for the files of outputs. */
  Path folder();

  /** Returns the figures of the gateway itself. */
  Health health();
}
