package no.hials.crosscom.protocol.server;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers a {@link ServerRequest} of type {@link MessageType#FEATURES} (type 14): 32 bytes.
 *
 * @param id u16, of the request
 * @param features 32 bytes, a bit for each type
 * @param tail the end of the answer
 */
public record FeaturesResponse(int id, Features features, Tail tail) implements TypedResponse {
  /** Checks the ranges. */
  public FeaturesResponse {
    Ranges.u16("id", id);
  }
}
