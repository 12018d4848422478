package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers without fields: a request whose answer has no fields (types 20, 22 to 25 and 63), or a
 * failed request of any type that only C3 Bridge supports.
 *
 * @param id u16, of the request
 * @param type u8, of the request
 * @param tail the end of the answer; a failure if the answers of the type have fields
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
