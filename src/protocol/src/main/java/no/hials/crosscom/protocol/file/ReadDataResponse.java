package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers {@link ReadDataRequest} (type 30): {@code 02, offset, size u32, data}.
 *
 * @param id u16, of the request
 * @param offset u32, of the request
 * @param data u32 count and bytes; 65,522 at most; a server sends 64,512 at most
 * @param tail the end of the answer
 */
public record ReadDataResponse(int id, long offset, Bytes data, Tail tail)
    implements TypedResponse {
  /** Checks the ranges. */
  public ReadDataResponse {
    Ranges.u16("id", id);
    Ranges.u32("offset", offset);
    Ranges.frame("data", 1 + 1 + 4 + 4 + data.size() + Tail.LENGTH);
  }
}
