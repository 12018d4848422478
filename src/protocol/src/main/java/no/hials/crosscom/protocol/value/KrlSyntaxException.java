package no.hials.crosscom.protocol.value;

/**
 * Thrown when a text is not the expected KRL value; has the position, and the expected and the
 * actual text.
 */
public final class KrlSyntaxException extends IllegalArgumentException {
  private static final long serialVersionUID = 1L;

  /** The number of characters that the message shows of a long text. */
  private static final int SHOWN = 120;

  private final String text;
  private final int position;
  private final String expected;
  private final String found;

  /**
   * Creates the exception.
   *
   * @param text the whole text
   * @param position the index of the error, from 0
   * @param expected the text that would be correct, as a phrase
   * @param found the actual text, as a phrase
   */
  public KrlSyntaxException(CharSequence text, int position, String expected, String found) {
    super(
        PrintableText.shortened(
            "expected "
                + expected
                + " at position "
                + position
                + ", found "
                + found
                + ", in: "
                + excerpt(text, position)));
    this.text = text.toString();
    this.position = position;
    this.expected = expected;
    this.found = found;
  }

  private static String excerpt(CharSequence text, int position) {
    int from = Math.max(0, Math.min(position - SHOWN / 2, text.length() - SHOWN));
    int to = Math.min(text.length(), from + SHOWN);
    return (from > 0 ? "..." : "") + text.subSequence(from, to) + (to < text.length() ? "..." : "");
  }

  /**
   * Returns the text that was parsed.
   *
   * @return the whole text
   */
  public String text() {
    return text;
  }

  /**
   * Returns the position of the error.
   *
   * @return an index into {@link #text()}, from 0; its length if the text ended too early
   */
  public int position() {
    return position;
  }

  /**
   * Returns the text that would be correct.
   *
   * @return a phrase
   */
  public String expected() {
    return expected;
  }

  /**
   * Returns the actual text.
   *
   * @return a phrase
   */
  public String found() {
    return found;
  }
}
