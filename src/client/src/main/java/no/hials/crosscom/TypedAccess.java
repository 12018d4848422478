package no.hials.crosscom;

import java.io.Closeable;
import java.io.IOException;
import java.util.List;
import no.hials.crosscom.KRL.KRLVariable;

/**
 * The calls of {@link CrossComClient} that read and write variables as Java values. They are built
 * on the calls for {@link KRLVariable}.
 */
abstract sealed class TypedAccess implements Closeable permits CrossComClient {

  /** Reads a variable of the controller into its local copy. */
  public abstract void readVariable(KRLVariable variable) throws IOException;

  /** Writes the local copy of a variable to the controller. */
  public abstract void writeVariable(KRLVariable variable) throws IOException;

  /** Reads several variables. */
  public abstract List<VariableResult> readVariables(List<? extends KRLVariable> several);

  /**
   * Returns a new handle for repeated access to a variable, without sending anything.
   *
   * @param name the variable's name
   * @param type the type of the values
   * @return the handle
   * @throws IllegalArgumentException if the name is blank or the type maps to no KRL type
   */
  public <T> Handle<T> handle(String name, Class<T> type) {
    return new Handle<>(this, name, type);
  }

  /**
   * Returns a new handle for repeated access to a REAL.
   *
   * @param name the variable's name
   * @return the handle
   * @throws IllegalArgumentException if the name is blank
   */
  public Handle.OfReal realHandle(String name) {
    return new Handle.OfReal(this, name);
  }

  /**
   * Returns a new handle for repeated access to an INT.
   *
   * @param name the variable's name
   * @return the handle
   * @throws IllegalArgumentException if the name is blank
   */
  public Handle.OfInt intHandle(String name) {
    return new Handle.OfInt(this, name);
  }
}
