package no.hials.crosscom.protocol;

/**
 * Asks to delete a file (c3-bridge.md, type 23): {@code always, name}.
 *
 * @param id u16, echoed in the answer
 * @param always u8, 0 or 1; whether to delete it although it is read-only (c3-vectors.tsv)
 * @param name WSTRING; 32,765 characters at most
 */
public record DeleteFileRequest(int id, boolean always, String name) implements Request {
  static final Layout<DeleteFileRequest> LAYOUT =
      new Layout<>(
          (m, out) -> {
            out.bool(m.always);
            out.putWide(m.name);
          },
          (id, in, tail) -> new DeleteFileRequest(id, in.bool("always"), in.wide("name")));

  /** Checks the ranges. */
  public DeleteFileRequest {
    Ranges.u16("id", id);
    Ranges.frame("name", 1 + 1 + Ranges.wide(name));
  }

  @Override
  public MessageType type() {
    return MessageType.DELETE_FILE;
  }
}
