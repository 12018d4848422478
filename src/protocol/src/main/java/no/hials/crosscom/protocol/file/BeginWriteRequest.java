package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Announces a file (type 29): {@code 01, size}.
 *
 * @param id u16, echoed in the answer
 * @param size u32; the size of the whole file in bytes
 */
public record BeginWriteRequest(int id, long size) implements FileRequest {
  /** Checks the ranges. */
  public BeginWriteRequest {
    Ranges.u16("id", id);
    Ranges.u32("size", size);
  }
}
