package no.hials.crosscom;

import no.hials.crosscom.KRL.KRLVariable;
import org.jspecify.annotations.Nullable;

/**
 * What came of reading or writing one of several variables.
 *
 * @param variable the variable; it has the new value if there is no failure
 * @param failure why it failed; null if it did not
 */
public record VariableResult(KRLVariable variable, @Nullable CrossComException failure) {

  /**
   * Says whether the variable was read or written.
   *
   * @return true if so
   */
  public boolean isOk() {
    return failure == null;
  }

  /**
   * Gives the variable, or throws what made it fail.
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
