package no.hials.crosscom.simulator;

import java.time.Duration;

/**
 * A message of the simulated controller, as the pendant would show it.
 *
 * @param kind what it asks of people
 * @param number its number; those of KSS where they are known, which few are: see {@link
 *     Controller}
 * @param text what it says, with file and line where it concerns a program
 * @param time when it came, in simulated time since the start
 */
public record Message(Kind kind, int number, String text, Duration time) {

  /** The kinds of message. */
  public enum Kind {
    /** Needs nothing. */
    NOTIFICATION,
    /** A program waits for something. */
    STATUS,
    /** Has stopped the robot, and has to be confirmed. */
    ACKNOWLEDGEMENT
  }

  @Override
  public String toString() {
    return number + " " + text;
  }
}
