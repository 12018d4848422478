package no.hials.crosscom.simulator;

import java.time.Duration;
import java.util.List;

/**
 * A message of the simulated controller, as the pendant would show it.
 *
 * @param kind the kind, which tells whether the operator must act
 * @param number its number, see {@link Controller}; that of a program is its own
 * @param text the text, with file and line if it concerns a program
 * @param time the simulated time of the message since the start
 * @param keys the labels of the keys of a dialogue, see {@link Controller#answer}; empty for a key
 *     without a label, and for all other messages
 * @param handle the handle by which programs know it, different for each message of a program; 0
 *     for a message of the controller itself
 */
public record Message(
    Kind kind, int number, String text, Duration time, List<String> keys, int handle) {

  /** Copies the list. */
  public Message {
    keys = List.copyOf(keys);
  }

  /** The kinds of message. */
  public enum Kind {
    /** No action needed. */
    NOTIFICATION,
    /** A state that lasts, such as a BCO run that is due; it disappears with the state. */
    STATUS,
    /** The robot was stopped, and the message has to be confirmed. */
    ACKNOWLEDGEMENT,
    /** The operator must choose one of its keys. */
    DIALOGUE
  }

  @Override
  public String toString() {
    return number + " " + text;
  }
}
