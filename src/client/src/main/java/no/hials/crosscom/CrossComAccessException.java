package no.hials.crosscom;

import java.util.Optional;
import no.hials.crosscom.protocol.ErrorCode;

/**
 * Thrown if the controller refuses to read or write a variable. Nothing was changed; the connection
 * can be used.
 */
public final class CrossComAccessException extends CrossComException {
  private static final long serialVersionUID = 1L;

  private final String variable;
  private final Operation operation;
  private final int code;

  CrossComAccessException(String variable, Operation operation, boolean success, int code) {
    super(
        "the controller refused to "
            + operation.verb
            + " "
            + variable
            + ": it answered "
            + (success
                ? "success with an empty value"
                : "failure, code " + code + " (" + nameOf(code) + ")")
            + "; likely cause: "
            + likelyCause(operation, success, code),
        null,
        false);
    this.variable = variable;
    this.operation = operation;
    this.code = code;
  }

  private static String nameOf(int code) {
    ErrorCode known = ErrorCode.from(code).orElse(null);
    if (known == null) {
      return "unknown";
    }
    return known == ErrorCode.SUCCESS ? "the server gives no reason" : known.name();
  }

  private static String likelyCause(Operation operation, boolean success, int code) {
    if (!success && ErrorCode.from(code).orElse(null) == ErrorCode.ACCESS) {
      return operation == Operation.WRITE
          ? "the variable is read-only"
          : "the variable is not readable";
    }
    return operation.likelyCause;
  }

  /** Returns the variable's name as it was sent. */
  public String getVariable() {
    return variable;
  }

  /** Returns whether a read or a write was refused. */
  public Operation getOperation() {
    return operation;
  }

  /** Returns the code in the answer's tail, 0 to 65535. KUKAVARPROXY sends 1 for every failure. */
  public int getCode() {
    return code;
  }

  /**
   * Returns the name of the code in C3 Bridge Interface.
   *
   * @return the name; {@link ErrorCode#SUCCESS} from KUKAVARPROXY, which sends no reason; empty if
   *     the code is unknown
   */
  public Optional<ErrorCode> getErrorCode() {
    return ErrorCode.from(code);
  }

  /** The refused access. */
  public enum Operation {
    /** Reading a variable. */
    READ("read", "the variable is unknown, not initialised or not readable"),
    /** Writing a variable. */
    WRITE(
        "write",
        "the variable is unknown or read-only, or the value is of the wrong type or out of range");

    private final String verb;
    private final String likelyCause;

    Operation(String verb, String likelyCause) {
      this.verb = verb;
      this.likelyCause = likelyCause;
    }
  }
}
