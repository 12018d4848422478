package no.hials.crosscom;

import java.util.Optional;
import no.hials.crosscom.protocol.ErrorCode;

/**
 * Thrown if C3 Bridge Interface refuses a command. For a refused access to a variable see {@link
 * CrossComAccessException}. The connection can be used.
 */
public final class CrossComRefusedException extends CrossComException {
  private static final long serialVersionUID = 1L;

  private final String command;
  private final int code;

  CrossComRefusedException(String command, int code) {
    this(command, code, "");
  }

  /**
   * Creates the exception.
   *
   * @param hint a text after the message, can be empty
   */
  CrossComRefusedException(String command, int code, String hint) {
    super(
        "the server refused the " + command + ": code " + code + describe(code) + hint,
        null,
        false);
    this.command = command;
    this.code = code;
  }

  /** Explains a code in words (docs/reference/c3-messages.md#error-codes). */
  private static String describe(int code) {
    return ErrorCode.from(code).map(known -> " (" + known + ": " + words(known) + ")").orElse("");
  }

  private static String words(ErrorCode code) {
    return switch (code) {
      case GENERAL -> "no reason given";
      case SUCCESS -> "failure with the code of success";
      case ACCESS -> "access denied";
      case ARGUMENT -> "invalid argument";
      case MEMORY -> "out of memory";
      case POINTER -> "null pointer";
      case UNEXPECTED -> "unexpected failure";
      case NOT_IMPLEMENTED -> "not implemented";
      case NO_INTERFACE -> "no interface";
      case PROTOCOL -> "the message's content is malformed";
      case LONG_ANSWER -> "the answer does not fit into one message";
    };
  }

  /** Returns the command that was refused, such as {@code selection of program /R1/MAIN}. */
  public String getCommand() {
    return command;
  }

  /** Returns the code in the answer's tail, 0 to 65535. */
  public int getCode() {
    return code;
  }

  /** Returns the name of the code; empty if the code is unknown. */
  public Optional<ErrorCode> getErrorCode() {
    return ErrorCode.from(code);
  }
}
