package no.hials.crosscom.protocol.server;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.internal.Ranges;

/** Answers a {@link ServerRequest}, unless it confirms messages. */
public sealed interface ServerResponse extends TypedResponse {

  /**
   * Answers a {@link ServerRequest} of type {@link MessageType#INFORMATION} (type 13): {@code
   * major, minor, build, time, computer name}.
   *
   * @param id u16, of the request
   * @param information u8 three times, u16 eight times, WSTRING
   * @param tail the end of the answer
   */
  record InformationResponse(int id, ServerInformation information, Tail tail)
      implements ServerResponse {
    /** Checks the ranges. */
    public InformationResponse {
      Ranges.u16("id", id);
      Ranges.frame(
          "computer name", 1 + 3 + 8 * 2 + Ranges.wide(information.computerName()) + Tail.LENGTH);
    }
  }

  /**
   * Answers a {@link ServerRequest} of type {@link MessageType#FEATURES} (type 14): 32 bytes.
   *
   * @param id u16, of the request
   * @param features 32 bytes, a bit for each type
   * @param tail the end of the answer
   */
  record FeaturesResponse(int id, Features features, Tail tail) implements ServerResponse {
    /** Checks the ranges. */
    public FeaturesResponse {
      Ranges.u16("id", id);
    }
  }
}
