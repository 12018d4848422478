package no.hials.crosscom;

import java.io.IOException;
import java.util.OptionalInt;
import org.jspecify.annotations.Nullable;

/**
 * Thrown if an operation of the client fails. The subclasses differ by what the caller can do about
 * it.
 */
public abstract sealed class CrossComException extends IOException
    permits CrossComConnectException,
        CrossComTimeoutException,
        CrossComConnectionLostException,
        CrossComProtocolException,
        CrossComAccessException,
        CrossComRefusedException,
        CrossComTransferException,
        CrossComUnsupportedException,
        CrossComValueException,
        CrossComClosedException {
  private static final long serialVersionUID = 1L;

  private final boolean outcomeUnknown;
  private int elementsDone = -1;
  private int elements;

  CrossComException(String message, @Nullable Throwable cause, boolean outcomeUnknown) {
    super(
        outcomeUnknown
            ? message + "; the outcome is unknown: the controller may or may not have done it"
            : message,
        cause);
    this.outcomeUnknown = outcomeUnknown;
  }

  /**
   * Returns whether this was a write or command that the controller may or may not have done. The
   * client never repeats it; read the state of the controller before you do.
   *
   * @return true if so; false for a read, and for a write or command that was certainly not done
   */
  public boolean isOutcomeUnknown() {
    return outcomeUnknown;
  }

  /** Notes how far reading or writing an array element by element had come. */
  final void setElementsDone(int done, int total) {
    elementsDone = done;
    elements = total;
  }

  /**
   * Returns how many elements of an array were read or written, if it went element by element.
   *
   * @return how many elements were done before the one that failed; nothing for other operations
   */
  public OptionalInt getElementsDone() {
    return elementsDone < 0 ? OptionalInt.empty() : OptionalInt.of(elementsDone);
  }

  @Override
  public @Nullable String getMessage() {
    return elementsDone < 0
        ? super.getMessage()
        : super.getMessage() + "; " + elementsDone + " of " + elements + " elements were done";
  }
}
