package no.hials.crosscom.networking;

import org.jspecify.annotations.Nullable;

/**
 * Asks for a read or a write by name.
 *
 * @deprecated use {@link no.hials.crosscom.CrossComClient#readVariable} and {@link
 *     no.hials.crosscom.CrossComClient#writeVariable}
 */
@Deprecated
public class Request extends no.hials.crosscom.Request {
  /**
   * Creates a read.
   *
   * @param id any number; the {@link Callback} returns it
   * @param variable the variable's name
   */
  public Request(int id, String variable) {
    super(id, variable);
  }

  /**
   * Creates a write, or a read if there is no value.
   *
   * @param id any number; the {@link Callback} returns it
   * @param variable the variable's name
   * @param value the value as KRL text; null for a read
   */
  public Request(int id, String variable, @Nullable String value) {
    super(id, variable, value);
  }
}
