package no.hials.crosscom.protocol.value;

/** Says that a text is not the KRL value it should be: where, what was expected, what was found. */
public final class KrlSyntaxException extends IllegalArgumentException {
  private static final long serialVersionUID = 1L;

  /** How much of a long text the message shows. */
  private static final int SHOWN = 120;

  private final String text;
  private final int position;
  private final String expected;
  private final String found;

  /**
   * Makes the exception.
   *
   * @param text the whole text
   * @param position the index in it at which it is wrong, from 0
   * @param expected what would have been right
   * @param found what is there
   */
  public KrlSyntaxException(CharSequence text, int position, String expected, String found) {
    super(
        "expected "
            + expected
            + " at position "
            + position
            + ", found "
            + found
            + ", in: "
            + excerpt(text, position));
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
   * Gives the text that was parsed.
   *
   * @return the whole text
   */
  public String text() {
    return text;
  }

  /**
   * Gives the place of the error.
   *
   * @return an index into {@link #text()}, from 0; its length if the text ended too early
   */
  public int position() {
    return position;
  }

  /**
   * Says what would have been right.
   *
   * @return a phrase
   */
  public String expected() {
    return expected;
  }

  /**
   * Says what stands there.
   *
   * @return a phrase
   */
  public String found() {
    return found;
  }
}
