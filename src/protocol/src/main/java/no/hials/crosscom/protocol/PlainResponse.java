package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers without fields: a request of a type whose answer has none (c3-bridge.md, types 20, 22 to
 * 25 and 63), or a failed one of any type that only C3 Bridge knows.
 *
 * @param id u16, of the request
 * @param type u8, of the request
 * @param tail how the access ended; failure if the type's answer has fields
 */
public record PlainResponse(int id, MessageType type, Tail tail) implements TypedResponse {
  /** Checks the ranges. */
  public PlainResponse {
    Ranges.u16("id", id);
    if (type.isKnownTo(ServerType.KUKAVARPROXY)) {
      throw new IllegalArgumentException("an answer of type " + type + " has a value");
    }
    if (tail.success()) {
      Ranges.type(
          type,
          MessageType.SET_ATTRIBUTES,
          MessageType.CREATE_FILE,
          MessageType.DELETE_FILE,
          MessageType.COPY_FILE,
          MessageType.MOVE_FILE,
          MessageType.CONFIRM_ALL);
    }
  }
}
