package no.hials.crosscom;

import no.hials.crosscom.internal.exchange.TextAnswer;
import no.hials.crosscom.protocol.AnswerFrame;
import no.hials.crosscom.protocol.MalformedFrameException;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.variables.Variable;

/**
 * The result of {@link CrossComClient#sendRequest}.
 *
 * @deprecated use {@link CrossComClient#readVariable} and {@link CrossComClient#writeVariable}
 */
@Deprecated
public final class Callback {
  private final String variableName;
  private final int id;
  private final int option;
  private final long readTime;
  private final String stringValue;

  Callback(Request request, TextAnswer answer) {
    this.variableName = request.getVariable();
    this.id = request.getId();
    this.option = (request.getValue() == null ? MessageType.READ : MessageType.WRITE).code();
    this.stringValue = answer.text().strip();
    this.readTime = answer.nanos();
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
    AnswerFrame answer = new AnswerFrame();
    try {
      answer.wrap(data, data.length);
      answer.openValue();
    } catch (MalformedFrameException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
    this.variableName = variable;
    this.id = answer.id();
    this.option = answer.function();
    this.stringValue = answer.toString();
    this.readTime = readTime;
  }

  /** Returns the variable's name. */
  public String getVariableName() {
    return variableName;
  }

  /** Returns the number of the {@link Request}. */
  public int getId() {
    return id;
  }

  /** Returns 0 for a read, 1 for a write. */
  public int getOption() {
    return option;
  }

  /** Returns the time from sending the request to having the answer, in ns. */
  public long getReadTime() {
    return readTime;
  }

  /** Returns the value as KRL text; empty if the controller refused the access. */
  public String getStringValue() {
    return stringValue;
  }

  /**
   * Parses the value.
   *
   * @return a variable of the text's type
   * @throws NumberFormatException if the text is empty or of no supported type
   */
  @SuppressWarnings("rawtypes") // as in the original, so that its programs compile
  public Variable getVariable() {
    return Variable.parseVariable(this);
  }

  @Override
  public String toString() {
    return "Callback{variable="
        + variableName
        + ", id="
        + id
        + ", option="
        + option
        + ", readTime="
        + readTime / 1_000_000
        + "ms, value="
        + stringValue
        + '}';
  }
}
