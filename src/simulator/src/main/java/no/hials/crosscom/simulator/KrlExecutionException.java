package no.hials.crosscom.simulator;

/** Thrown when a KRL statement cannot be executed. The program stops with a message. */
public final class KrlExecutionException extends Exception {
  private static final long serialVersionUID = 1L;

  // KSS's own numbers where they are known (docs/reference/simulated-controller.md#messages);
  // those from 9005 are this simulation's own

  /** A variable, or a part of it, was read before it had a value. */
  public static final int NOT_INITIALISED = 1422;

  /** An index is outside the range of its array. */
  public static final int BAD_INDEX = 1444;

  /** A value is of the wrong type. */
  public static final int WRONG_TYPE = 1446;

  /** A value is of the right type but not allowed. */
  public static final int OUT_OF_RANGE = 1422;

  /** A number is divided by zero. */
  public static final int DIVISION_BY_ZERO = 9005;

  /** A result is too large for its type. */
  public static final int OVERFLOW = 9006;

  /** A variable cannot be written. */
  public static final int READ_ONLY = 1388;

  /** Calls are nested too deeply. */
  public static final int CALL_STACK = 1424;

  /** A function ended without a value. */
  public static final int NO_RESULT = 9009;

  /** A statement is not allowed in this place or at this time. */
  public static final int NOT_ALLOWED = 9010;

  /**
   * An interrupt is not declared; assumed from programs that compare {@code $ERR.NUMBER} with it.
   */
  public static final int NO_INTERRUPT = 1430;

  /** A channel cannot be opened or used. */
  public static final int CHANNEL = 1007;

  /** An assignment cannot be evaluated in cycles. */
  public static final int CYCLIC_FLAG = 1609;

  /** The simulation itself has failed. */
  public static final int SIMULATION_FAILED = 9107;

  private final int number;

  /**
   * Creates the exception.
   *
   * @param number the number of the message
   * @param text the rule that broke, expected and actual
   */
  public KrlExecutionException(int number, String text) {
    // without a stack trace: only the position in the program matters
    super(text, null, false, false);
    this.number = number;
  }

  /**
   * Creates the exception of an access that was refused.
   *
   * @param name the variable
   * @param refused the reason
   * @return the exception
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
   * Returns the number of the message.
   *
   * @return the number
   */
  public int number() {
    return number;
  }
}
