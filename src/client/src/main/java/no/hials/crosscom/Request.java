package no.hials.crosscom;

import no.hials.crosscom.internal.BoxedFrame;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import org.jspecify.annotations.Nullable;

/**
 * Asks for a read or a write by name, for {@link CrossComClient#sendRequest}. It is a write if it
 * has a value, whatever its id.
 *
 * @deprecated use {@link CrossComClient#readVariable} and {@link CrossComClient#writeVariable}, or
 *     {@link CrossComClient#readText} and {@link CrossComClient#writeText} if the type is not known
 */
@Deprecated
public final class Request {
  private final int id;
  private final String variable;
  private final @Nullable String value;

  /**
   * Creates a read.
   *
   * @param id any number; the {@link Callback} returns it
   * @param variable the variable's name
   */
  public Request(int id, String variable) {
    this(id, variable, null);
  }

  /**
   * Creates a write, or a read if there is no value.
   *
   * @param id any number; the {@link Callback} returns it
   * @param variable the variable's name
   * @param value the value as KRL text; null for a read
   */
  public Request(int id, String variable, @Nullable String value) {
    this.id = id;
    this.variable = variable;
    this.value = value;
  }

  /** Returns the number of this request. */
  public int getId() {
    return id;
  }

  /** Returns the variable's name. */
  public String getVariable() {
    return variable;
  }

  /** Returns the value to write as KRL text; null for a read. */
  public @Nullable String getValue() {
    return value;
  }

  /** Returns the frame of this request. */
  public Byte[] getCmd() {
    return BoxedFrame.of(
        value == null
            ? new ReadRequest(id & 0xFFFF, variable)
            : new WriteRequest(id & 0xFFFF, variable, value));
  }
}
