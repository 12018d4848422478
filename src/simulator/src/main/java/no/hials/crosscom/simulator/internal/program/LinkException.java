package no.hials.crosscom.simulator.internal.program;

import java.util.List;
import java.util.stream.Collectors;
import no.hials.crosscom.lang.KrlError;

/** Thrown if a program cannot be selected. */
public final class LinkException extends Exception {
  private static final long serialVersionUID = 1L;

  private final transient List<KrlError> errors;

  /**
   * Creates the exception.
   *
   * @param errors the errors of the module and of the modules it calls; at least one
   */
  public LinkException(List<KrlError> errors) {
    super(errors.stream().map(KrlError::toString).collect(Collectors.joining("; ")));
    this.errors = List.copyOf(errors);
  }

  /** Returns the errors; at least one. */
  public List<KrlError> errors() {
    return errors;
  }
}
