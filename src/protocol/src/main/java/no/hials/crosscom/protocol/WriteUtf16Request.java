package no.hials.crosscom.protocol;

/**
 * Sets a variable from text (c3-bridge.md, type 5): {@code name, value}.
 *
 * @param id u16, echoed in the answer
 * @param name WSTRING
 * @param value WSTRING; name and value have 32,765 characters together at most
 */
public record WriteUtf16Request(int id, String name, String value) implements Request {
  static final Layout<WriteUtf16Request> LAYOUT =
      new Layout<>(
          (m, out) -> {
            out.putWide(m.name);
            out.putWide(m.value);
          },
          (id, in, tail) -> new WriteUtf16Request(id, in.wide("name"), in.wide("value")));

  /** Checks the ranges. */
  public WriteUtf16Request {
    Ranges.u16("id", id);
    Ranges.frame("name and value", 1 + Ranges.wide(name) + Ranges.wide(value));
  }

  @Override
  public MessageType type() {
    return MessageType.WRITE_UTF16;
  }
}
