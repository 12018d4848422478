package no.hials.crosscom.simulator;

/** Says why a program cannot go on. It stops with a message. */
public final class KrlExecutionException extends Exception {
  private static final long serialVersionUID = 1L;

  /*
   * The numbers are this simulation's own: no source has the numbers of KSS.
   */

  /** A variable, or a part of it, was read before it had a value. */
  public static final int NOT_INITIALISED = 9001;

  /** An index is not in the range of its array. */
  public static final int BAD_INDEX = 9002;

  /** A value is not of the type that is needed. */
  public static final int WRONG_TYPE = 9003;

  /** A value is of the right type and still not possible. */
  public static final int OUT_OF_RANGE = 9004;

  /** A number is divided by zero. */
  public static final int DIVISION_BY_ZERO = 9005;

  /** A result is too large for its type. */
  public static final int OVERFLOW = 9006;

  /** The variable must not be written. */
  public static final int READ_ONLY = 9007;

  /** Calls are nested too deep. */
  public static final int CALL_STACK = 9008;

  /** A function ended without a value. */
  public static final int NO_RESULT = 9009;

  /** A statement is not allowed in this place or at this time. */
  public static final int NOT_ALLOWED = 9010;

  private final int number;

  /**
   * Makes the fault.
   *
   * @param number the number of the message
   * @param text the rule that broke, what was expected and what was found
   */
  public KrlExecutionException(int number, String text) {
    // without a stack trace: the position in the program is what matters
    super(text, null, false, false);
    this.number = number;
  }

  /**
   * Makes the fault of an access that was refused.
   *
   * @param name the variable
   * @param refused why
   * @return the fault
   */
  public static KrlExecutionException of(String name, RefusedException refused) {
    int number =
        switch (refused.reason()) {
          case NOT_INITIALISED -> NOT_INITIALISED;
          case BAD_INDEX -> BAD_INDEX;
          case READ_ONLY -> READ_ONLY;
          case OUT_OF_RANGE, TOO_LONG -> OUT_OF_RANGE;
          case UNKNOWN_VARIABLE, UNKNOWN_COMPONENT, NO_VALUE, WRONG_TYPE, WHOLE_ARRAY -> WRONG_TYPE;
        };
    return new KrlExecutionException(number, name + ": " + refused.getMessage());
  }

  /**
   * Gives the number.
   *
   * @return the number of the message
   */
  public int number() {
    return number;
  }
}
