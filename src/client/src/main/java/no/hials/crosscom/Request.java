package no.hials.crosscom;

import no.hials.crosscom.internal.BoxedFrame;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import org.jspecify.annotations.Nullable;

/**
 * Asks for a read or a write by name, for {@link CrossComClient#sendRequest}. It is a write if it
 * has a value, whatever its id. Programs may derive classes; {@link #getCmd} is not called to send
 * a request.
 *
 * @deprecated use {@link CrossComClient#readVariable} and {@link CrossComClient#writeVariable}, or
 *     {@link CrossComClient#readText} and {@link CrossComClient#writeText} if the type is not known
 */
@Deprecated
public class Request {
  /** The function of a read. */
  public static final char READ = 0;

  /** The function of a write. */
  public static final char WRITE = 1;

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

  /** Returns the number of this request. Not public: a program's class may have such a method. */
  int getId() {
    return id;
  }

  /** Returns the variable's name. */
  public String getVariable() {
    return variable;
  }

  /** Returns the value to write as KRL text; null for a read. */
  @Nullable String getValue() {
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
