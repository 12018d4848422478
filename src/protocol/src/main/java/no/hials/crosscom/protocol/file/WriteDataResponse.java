package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers {@link WriteDataRequest} (type 29): {@code 02, offset, written}.
 *
 * @param id u16, of the request
 * @param offset u32, of the request
 * @param written u32; the number of bytes accepted: those within the announced size
 * @param tail the end of the answer
 */
public record WriteDataResponse(int id, long offset, long written, Tail tail)
    implements TypedResponse {
  /** Checks the ranges. */
  public WriteDataResponse {
    Ranges.u16("id", id);
    Ranges.u32("offset", offset);
    Ranges.u32("written", written);
  }
}
