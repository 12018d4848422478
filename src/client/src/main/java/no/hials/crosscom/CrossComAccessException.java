package no.hials.crosscom;

/**
 * Says that the controller refused to read or write a variable. Nothing was changed; the connection
 * can be used.
 */
public final class CrossComAccessException extends CrossComException {
  private static final long serialVersionUID = 1L;

  private final String variable;
  private final Operation operation;
  private final int code;

  CrossComAccessException(String variable, Operation operation, int code, String said) {
    super(
        "the controller refused to "
            + operation.verb
            + " "
            + variable
            + ": "
            + said
            + "; likely cause: "
            + operation.likelyCause,
        null,
        false);
    this.variable = variable;
    this.operation = operation;
    this.code = code;
  }

  /**
   * Gives the variable's name.
   *
   * @return the name as it was sent
   */
  public String getVariable() {
    return variable;
  }

  /**
   * Says what was tried.
   *
   * @return read or write
   */
  public Operation getOperation() {
    return operation;
  }

  /**
   * Gives the code in the answer's tail. KUKAVARPROXY always sends 1, whatever went wrong.
   *
   * @return 0 to 65535
   */
  public int getCode() {
    return code;
  }

  /** What was tried. */
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
