package no.hials.crosscom.simulator;

import java.util.List;
import java.util.stream.Collectors;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.protocol.value.PrintableText;

/** Thrown if a data list or a program has errors; nothing has been loaded. */
public final class KrlFileException extends Exception {
  private static final long serialVersionUID = 1L;

  /** The number of errors in the message; a file that is not a data list has hundreds. */
  private static final int SHOWN = 20;

  private final transient List<KrlError> errors;

  /**
   * Creates the exception.
   *
   * @param errors the errors in the order of the file; at least one
   */
  public KrlFileException(List<KrlError> errors) {
    super(message(errors));
    this.errors = List.copyOf(errors);
  }

  private static String message(List<KrlError> errors) {
    String shown =
        errors.stream()
            .limit(SHOWN)
            .map(error -> PrintableText.of(error.toString()))
            .collect(Collectors.joining("\n"));
    int rest = errors.size() - SHOWN;
    return rest > 0 ? shown + "\nand " + rest + " more" : shown;
  }

  /**
   * Returns the errors.
   *
   * @return the errors in the order of the file, each with its position
   */
  public List<KrlError> errors() {
    return errors;
  }
}
