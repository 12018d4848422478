package no.hials.crosscom;

import java.io.IOException;
import java.util.OptionalInt;
import no.hials.crosscom.protocol.value.PrintableText;
import org.jspecify.annotations.Nullable;

/**
 * Thrown if an operation of the client fails. There is one subclass for each cause that callers
 * handle differently. The message is safe to print on one line; of more than 2000 characters it
 * leaves out the middle.
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
  private static final String OUTCOME_UNKNOWN =
      "; the outcome is unknown: the controller may or may not have done it";

  private final boolean outcomeUnknown;
  private int elementsDone = -1;
  private int elements;

  CrossComException(String message, @Nullable Throwable cause, boolean outcomeUnknown) {
    super(PrintableText.shortened(message) + (outcomeUnknown ? OUTCOME_UNKNOWN : ""), cause);
    this.outcomeUnknown = outcomeUnknown;
  }

  /**
   * Returns whether the controller may have carried out the failed write or command. The client
   * never repeats it; check the controller before you repeat it.
   *
   * @return true if so; false for a read, and for a write or command that was certainly not carried
   *     out
   */
  public boolean isOutcomeUnknown() {
    return outcomeUnknown;
  }

  /** Sets the progress of reading or writing an array element by element. */
  final void setElementsDone(int done, int total) {
    elementsDone = done;
    elements = total;
  }

  /**
   * Returns the number of array elements done before the failure.
   *
   * @return the number of elements; empty unless the array was accessed element by element
   */
  public OptionalInt getElementsDone() {
    return elementsDone < 0 ? OptionalInt.empty() : OptionalInt.of(elementsDone);
  }

  /** Returns the message without the outcome of the failed operation, for that of a later one. */
  final String reason() {
    String message = String.valueOf(super.getMessage());
    return outcomeUnknown
        ? message.substring(0, message.length() - OUTCOME_UNKNOWN.length())
        : message;
  }

  @Override
  public @Nullable String getMessage() {
    return elementsDone < 0
        ? super.getMessage()
        : super.getMessage() + "; " + elementsDone + " of " + elements + " elements were done";
  }
}
