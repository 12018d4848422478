package no.hials.crosscom.internal.exchange;

/**
 * A value that the server sent.
 *
 * @param text the value as KRL text
 * @param nanos how long the exchange took, in ns
 */
public record TextAnswer(String text, long nanos) {
  /** Describes the access to a variable in one line. */
  public String describe(String name) {
    return name + " #read time=" + nanos / 1_000_000 + "ms  #value=" + text.strip();
  }
}
