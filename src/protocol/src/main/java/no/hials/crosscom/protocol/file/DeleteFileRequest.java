package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks to delete a file (type 23): {@code always, name}.
 *
 * @param id u16, echoed in the answer
 * @param always u8, 0 or 1; whether to delete it if it is read-only
 * @param name WSTRING; 32,765 characters at most
 */
public record DeleteFileRequest(int id, boolean always, String name) implements FileRequest {
  /** Checks the ranges. */
  public DeleteFileRequest {
    Ranges.u16("id", id);
    Ranges.frame("name", 1 + 1 + Ranges.wide(name));
  }
}
