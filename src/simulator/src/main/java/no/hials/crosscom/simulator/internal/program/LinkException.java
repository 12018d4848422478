package no.hials.crosscom.simulator.internal.program;

import java.util.List;
import java.util.stream.Collectors;
import no.hials.crosscom.lang.KrlError;

/** Says why a program cannot be selected. */
public final class LinkException extends Exception {
  private static final long serialVersionUID = 1L;

  private final transient List<KrlError> errors;

  /**
   * Makes the exception.
   *
   * @param errors what is wrong in the module and in those that it calls; at least one
   */
  public LinkException(List<KrlError> errors) {
    super(errors.stream().map(KrlError::toString).collect(Collectors.joining("; ")));
    this.errors = List.copyOf(errors);
  }

  /**
   * Gives the errors.
   *
   * @return what is wrong
   */
  public List<KrlError> errors() {
    return errors;
  }
}
