package no.hials.crosscom.protocol;

import java.util.Optional;
import no.hials.crosscom.protocol.code.WireCode;

/**
 * The error codes of C3 Bridge Interface, in the tail of an answer that reports a failure
 * (docs/reference/c3-messages.md#error-codes). KUKAVARPROXY has no codes: its tail has a length
 * there, which is always 1.
 */
public enum ErrorCode implements WireCode {
  /** Unspecified, such as an unknown variable or a refused write. */
  GENERAL(0),
  /** No error. Together with a failure, the sign of a KUKAVARPROXY, which sends no reason. */
  SUCCESS(1),
  /** Access denied. */
  ACCESS(2),
  /** Invalid argument. */
  ARGUMENT(3),
  /** Out of memory. */
  MEMORY(4),
  /** Null pointer. */
  POINTER(5),
  /** Unexpected failure. */
  UNEXPECTED(6),
  /** Not implemented. */
  NOT_IMPLEMENTED(7),
  /** No interface. */
  NO_INTERFACE(8),
  /** The message's content is malformed. */
  PROTOCOL(9),
  /** The answer does not fit into one message. */
  LONG_ANSWER(10);

  private final int code;

  ErrorCode(int code) {
    this.code = code;
  }

  /**
   * Returns the number on the wire.
   *
   * @return 0 to 10
   */
  @Override
  public int code() {
    return code;
  }

  /**
   * Returns the code with a number.
   *
   * @param code any number
   * @return the code, or empty if it is unknown
   */
  public static Optional<ErrorCode> from(int code) {
    return WireCode.find(ErrorCode.class, code);
  }
}
