package no.hials.crosscom.simulator.internal.files;

import java.io.IOException;
import no.hials.crosscom.protocol.ErrorCode;

/** Thrown when the file system refuses a request; nothing has changed. */
public final class FileRefusedException extends IOException {
  private static final long serialVersionUID = 1L;

  private final ErrorCode code;

  public FileRefusedException(ErrorCode code, String message) {
    super(message);
    this.code = code;
  }

  public ErrorCode code() {
    return code;
  }

  static FileRefusedException missing(ControllerPath path) {
    return new FileRefusedException(ErrorCode.GENERAL, path + " does not exist");
  }

  static FileRefusedException access(ControllerPath path, String rule) {
    return new FileRefusedException(ErrorCode.ACCESS, path + " " + rule);
  }

  static FileRefusedException argument(String message) {
    return new FileRefusedException(ErrorCode.ARGUMENT, message);
  }
}
