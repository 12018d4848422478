package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Sends a part of a file (type 29): {@code 02, offset, size u32, data}.
 *
 * @param id u16, echoed in the answer
 * @param offset u32; the index of the data in the file
 * @param data u32 count and bytes; 65,525 at most
 */
public record WriteDataRequest(int id, long offset, Bytes data) implements FileRequest {
  /** Checks the ranges. */
  public WriteDataRequest {
    Ranges.u16("id", id);
    Ranges.u32("offset", offset);
    Ranges.frame("data", 1 + 1 + 4 + 4 + data.size());
  }
}
