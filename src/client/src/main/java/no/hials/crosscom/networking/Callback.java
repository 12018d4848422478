package no.hials.crosscom.networking;

import no.hials.crosscom.variables.Variable;

/**
 * The result of {@link CrossComClient#sendRequest}.
 *
 * @deprecated use {@link no.hials.crosscom.CrossComClient#readVariable} and {@link
 *     no.hials.crosscom.CrossComClient#writeVariable}
 */
@Deprecated
public final class Callback {
  private final no.hials.crosscom.Callback callback;

  Callback(no.hials.crosscom.Callback callback) {
    this.callback = callback;
  }

  /**
   * Creates a callback from an answer's bytes.
   *
   * @param variable the variable's name
   * @param data the whole answer
   * @param readTime the time of the exchange in ns
   * @throws IllegalArgumentException if the bytes are not the answer to a read or write
   */
  public Callback(String variable, byte[] data, long readTime) {
    this(new no.hials.crosscom.Callback(variable, data, readTime));
  }

  /** Returns the variable's name. */
  public String getVariableName() {
    return callback.getVariableName();
  }

  /** Returns the number of the {@link Request}. */
  public int getId() {
    return callback.getId();
  }

  /** Returns 0 for a read, 1 for a write. */
  public int getOption() {
    return callback.getOption();
  }

  /** Returns the time from sending the request to having the answer, in ns. */
  public long getReadTime() {
    return callback.getReadTime();
  }

  /** Returns the value as KRL text; empty if the controller refused the access. */
  public String getStringValue() {
    return callback.getStringValue();
  }

  /**
   * Parses the value.
   *
   * @return a variable of the text's type
   * @throws NumberFormatException if the text is empty or of no supported type
   */
  @SuppressWarnings("rawtypes") // as in the original, so that its programs compile
  public Variable getVariable() {
    return callback.getVariable();
  }

  @Override
  public String toString() {
    return callback.toString();
  }
}
