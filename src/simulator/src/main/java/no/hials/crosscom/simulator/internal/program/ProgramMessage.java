package no.hials.crosscom.simulator.internal.program;

import java.util.List;

/**
 * A message of a program.
 *
 * @param type its type
 * @param number its number; 0 without one
 * @param module the text before the message; empty without one
 * @param text its text, with the values of its parameters
 * @param keys the labels of the keys of a dialogue; empty for the other types, and for keys without
 *     a label
 * @param clearedByReset whether it ends with the reset or the end of the selection of its program
 * @param clearedByBlockSelection whether it ends with a block selection
 */
public record ProgramMessage(
    Type type,
    int number,
    String module,
    String text,
    List<String> keys,
    boolean clearedByReset,
    boolean clearedByBlockSelection) {

  /** Copies the list. */
  public ProgramMessage {
    keys = List.copyOf(keys);
  }

  /** The types of message; the constants of EKRLMSGTYPE, and a dialogue. */
  public enum Type {
    /** Shown once. */
    NOTIFY,
    /** Shown until the program clears it. */
    STATE,
    /** Shown until the operator confirms it. */
    QUIT,
    /** Shown while the program waits. */
    WAITING,
    /** Shown until the operator presses one of its keys. */
    DIALOGUE
  }

  /** Returns the module and the text. */
  public String fullText() {
    return module.isBlank() ? text : module + ": " + text;
  }
}
