package no.hials.crosscom.cell.feed;

import java.time.Duration;
import java.util.List;

/**
 * Variables that are read together.
 *
 * @param name the name in the configuration
 * @param robots the names of the robots that they are read from; empty for all robots
 * @param variables the variables, structures or fields, at least one
 * @param period the time from one reading to the next
 * @param onChange whether only changed values are passed on
 * @param deadBand the difference up to which a REAL counts as unchanged, in its own unit; a
 *     variable can have its own
 */
public record Group(
    String name,
    List<String> robots,
    List<String> variables,
    Duration period,
    boolean onChange,
    double deadBand) {

  /** Copies the lists. */
  public Group {
    robots = List.copyOf(robots);
    variables = List.copyOf(variables);
  }
}
