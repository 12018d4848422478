package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.file.FileRequest.FileNameRequest;
import no.hials.crosscom.protocol.internal.Ranges;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadUtf16Request;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteUtf16Request;

/**
 * Answers with a text: {@link ReadUtf16Request} and {@link WriteUtf16Request} with the value,
 * {@link FileNameRequest} with the name (types 4, 5, 27 and 28).
 *
 * @param id u16, of the request
 * @param type u8, of the request
 * @param text WSTRING: u16 count of characters and UTF-16, little-endian; 32,764 at most. Empty if
 *     the access failed
 * @param tail the end of the answer
 */
public record TextResponse(int id, MessageType type, String text, Tail tail)
    implements TypedResponse {
  /** Checks the ranges. */
  public TextResponse {
    Ranges.u16("id", id);
    Ranges.type(
        type,
        MessageType.READ_UTF16,
        MessageType.WRITE_UTF16,
        MessageType.FULL_NAME,
        MessageType.KRC_NAME);
    Ranges.frame("text", 1 + Ranges.wide(text) + Tail.LENGTH);
  }
}
