package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers {@link FilePropertiesRequest} (type 26).
 *
 * @param id u16, of the request
 * @param properties 56 bytes and WSTRING; {@link FileProperties#NONE} if the access failed
 * @param tail the end of the answer
 */
public record FilePropertiesResponse(int id, FileProperties properties, Tail tail)
    implements TypedResponse {
  /** Checks the ranges. */
  public FilePropertiesResponse {
    Ranges.u16("id", id);
    Ranges.frame(
        "name", 1 + FileProperties.FIXED_LENGTH + Ranges.wide(properties.name()) + Tail.LENGTH);
  }
}
