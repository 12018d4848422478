package no.hials.crosscom;

import no.hials.crosscom.KRL.KRLVariable;
import org.jspecify.annotations.Nullable;

/**
 * The result of reading or writing one of several variables.
 *
 * @param variable the variable, which has the new value after a success
 * @param failure the failure; null after a success
 */
public record VariableResult(KRLVariable variable, @Nullable CrossComException failure) {

  /** Returns whether the variable was read or written. */
  public boolean isOk() {
    return failure == null;
  }

  /**
   * Returns the variable, or throws the failure.
   *
   * @return the variable
   * @throws CrossComException the failure
   */
  public KRLVariable orThrow() throws CrossComException {
    if (failure != null) {
      throw failure;
    }
    return variable;
  }
}
