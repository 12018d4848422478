package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.internal.FieldReader;
import no.hials.crosscom.protocol.value.KrlScanner;

/**
 * A view of one answer in a buffer. It can be moved to the next answer without creating objects.
 *
 * <p>The view checks the header and the tail. If the answer has a value, the view is the value as a
 * {@link CharSequence}, without a copy, until the buffer changes. Not thread-safe.
 */
public final class AnswerFrame implements CharSequence {
  /** The length of the shortest answer with a type: header, function and tail. */
  private static final int MIN_TYPED = Codec.HEADER_LENGTH + 1 + Tail.LENGTH;

  private static final int FIELDS = Codec.HEADER_LENGTH + 1;

  private byte[] bytes = new byte[0];
  private int length;
  private int valueStart;
  private int valueEnd;

  /** Creates a view without an answer. */
  public AnswerFrame() {}

  /**
   * Moves the view to an answer.
   *
   * @param frame a buffer that begins with the answer
   * @param frameLength the length of the answer in bytes
   * @throws MalformedFrameException if the bytes cannot be an answer
   */
  public void wrap(byte[] frame, int frameLength) throws MalformedFrameException {
    bytes = frame;
    length = frameLength;
    valueStart = 0;
    valueEnd = 0;
    Codec.checkLength(frame, frameLength);
    if (frameLength != Codec.HEADER_LENGTH && frameLength < MIN_TYPED) {
      throw malformed(
          "an answer has 0 or at least "
              + (MIN_TYPED - Codec.HEADER_LENGTH)
              + " bytes after its length, has "
              + (frameLength - Codec.HEADER_LENGTH));
    }
  }

  /**
   * Creates an exception with the bytes of this answer.
   *
   * @param what the rule that broke, expected and actual
   * @return the exception, to be thrown
   */
  public MalformedFrameException malformed(String what) {
    return new MalformedFrameException(what, bytes, length);
  }

  /**
   * Returns the number of the request.
   *
   * @return 0 to 65535
   */
  public int id() {
    return FieldReader.u16At(bytes, 0);
  }

  /**
   * Returns whether the server does not support the function, so that nothing follows the length.
   *
   * @return true if so; then the answer has no function, value or tail
   */
  public boolean functionUnknown() {
    return length == Codec.HEADER_LENGTH;
  }

  /**
   * Returns the function byte.
   *
   * @return 0 to 255
   */
  public int function() {
    return bytes[Codec.HEADER_LENGTH] & 0xFF;
  }

  /**
   * Returns whether the access succeeded.
   *
   * @return true for success
   */
  public boolean success() {
    return bytes[length - 1] != 0;
  }

  /**
   * Returns the code of the tail.
   *
   * @return 0 to 65535
   */
  public int code() {
    return FieldReader.u16At(bytes, length - Tail.LENGTH);
  }

  /** Returns a reader of the fields between the function and the tail. */
  FieldReader fields() {
    return new FieldReader(bytes, length, FIELDS, length - Tail.LENGTH, Strictness.STRICT);
  }

  /**
   * Finds the value; from now on this view is the value as a {@link CharSequence}.
   *
   * @throws MalformedFrameException if the value does not fill the bytes between function and tail
   */
  public void openValue() throws MalformedFrameException {
    int room = length - Tail.LENGTH - FIELDS - 2;
    if (room < 0 || FieldReader.u16At(bytes, FIELDS) != room) {
      throw malformed(
          room < 0
              ? "an answer with a value has at least 6 bytes after its length, has " + (length - 4)
              : "value length must be " + room + ", is " + FieldReader.u16At(bytes, FIELDS));
    }
    valueStart = FIELDS + 2;
    valueEnd = valueStart + room;
  }

  /**
   * Starts a scanner on the value.
   *
   * @param scanner the scanner
   */
  public void scan(KrlScanner scanner) {
    scanner.reset(this, bytes, valueStart);
  }

  @Override
  public int length() {
    return valueEnd - valueStart;
  }

  @Override
  public char charAt(int index) {
    return (char) (bytes[valueStart + index] & 0xFF);
  }

  @Override
  public CharSequence subSequence(int start, int end) {
    return FieldReader.latin1At(bytes, valueStart + start, end - start);
  }

  @Override
  public String toString() {
    return FieldReader.latin1At(bytes, valueStart, valueEnd - valueStart);
  }
}
