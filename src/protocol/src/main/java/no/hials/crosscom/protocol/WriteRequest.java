package no.hials.crosscom.protocol;

/**
 * Sets a variable from text: {@code id, length, 01, name length, name, value length, value}.
 *
 * @param id u16, echoed in the answer
 * @param name u16 byte count and ISO 8859-1 bytes
 * @param value u16 byte count and ISO 8859-1 bytes; name and value have 65,530 together at most
 */
public record WriteRequest(int id, String name, String value) implements Request {
  static final Layout<WriteRequest> LAYOUT =
      new Layout<>(
          (m, out) -> put(out, m.name, m.value),
          (id, in, tail) -> new WriteRequest(id, in.string("name"), in.string("value")));

  /** Checks the ranges. */
  public WriteRequest {
    Ranges.u16("id", id);
    check(name, value);
  }

  static void check(CharSequence name, CharSequence value) {
    Ranges.latin1("name", name);
    Ranges.latin1("value", value);
    Ranges.frame("name and value", 1 + 2 + name.length() + 2 + value.length());
  }

  static void put(WireBuffer out, CharSequence name, CharSequence value) {
    out.putString(name);
    out.putString(value);
  }

  @Override
  public MessageType type() {
    return MessageType.WRITE;
  }
}
