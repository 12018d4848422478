package no.hials.crosscom.protocol.code;

/** The steps of writing or reading a file's content (types 29 and 30). */
public enum ContentOperation implements WireCode {
  /** Prepares the server's buffer. */
  BEGIN(1),
  /** Moves a chunk. */
  DATA(2),
  /** Asks for the size of the buffer. */
  SIZE(3),
  /** Ends it; when writing, stores the buffer as a file. */
  END(4);

  private final int code;

  ContentOperation(int code) {
    this.code = code;
  }

  @Override
  public int code() {
    return code;
  }
}
