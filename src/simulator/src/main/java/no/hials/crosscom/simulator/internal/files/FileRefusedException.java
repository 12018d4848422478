package no.hials.crosscom.simulator.internal.files;

import java.io.IOException;
import no.hials.crosscom.protocol.ErrorCode;

/** Says why the file tree did not do what it was asked for; nothing has changed. */
public final class FileRefusedException extends IOException {
  private static final long serialVersionUID = 1L;

  private final ErrorCode code;

  /**
   * Makes the exception.
   *
   * @param code what C3 Bridge answers, not {@link ErrorCode#SUCCESS}
   * @param message the rule, expected and actual
   */
  public FileRefusedException(ErrorCode code, String message) {
    super(message);
    this.code = code;
  }

  /**
   * Gives what C3 Bridge answers.
   *
   * @return the code, never {@link ErrorCode#SUCCESS}
   */
  public ErrorCode code() {
    return code;
  }

  static FileRefusedException missing(ControllerPath path) {
    return new FileRefusedException(ErrorCode.GENERAL, path + " is not there");
  }

  static FileRefusedException access(ControllerPath path, String rule) {
    return new FileRefusedException(ErrorCode.ACCESS, path + " " + rule);
  }

  static FileRefusedException argument(String message) {
    return new FileRefusedException(ErrorCode.ARGUMENT, message);
  }
}
