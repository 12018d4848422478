package no.hials.crosscom.protocol;

/**
 * Asks for an INT array as 16-bit numbers: {@code id, length, 02, name length, name}.
 *
 * @param id u16, echoed in the answer
 * @param name u16 byte count and ISO 8859-1 bytes; 65,532 at most
 */
public record ReadArrayRequest(int id, String name) implements Request {
  static final Layout<ReadArrayRequest> LAYOUT =
      new Layout<>(
          (m, out) -> out.putString(m.name),
          (id, in, tail) -> new ReadArrayRequest(id, in.string("name")));

  /** Checks the ranges. */
  public ReadArrayRequest {
    Ranges.u16("id", id);
    Ranges.latin1("name", name);
    Ranges.frame("name", 1 + 2 + name.length());
  }

  @Override
  public MessageType type() {
    return MessageType.READ_ARRAY;
  }
}
