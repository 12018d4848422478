package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers an operation on a file's content with only its number (types 29 and 30): the end, or a
 * failed operation.
 *
 * @param id u16, of the request
 * @param type u8; {@link MessageType#WRITE_CONTENT} or {@link MessageType#READ_CONTENT}
 * @param operation u8, of the request, known or not
 * @param tail the end of the answer; a failure if the answers of the operation have fields
 */
public record ContentResponse(int id, MessageType type, Code<ContentOperation> operation, Tail tail)
    implements TypedResponse {

  /** Checks the ranges. */
  public ContentResponse {
    Ranges.u16("id", id);
    Ranges.type(type, MessageType.WRITE_CONTENT, MessageType.READ_CONTENT);
    Ranges.u8("operation", operation.number());
    if (tail.success()
        && (operation.is(ContentOperation.DATA) || ContentSizeResponse.isFor(operation))) {
      throw new IllegalArgumentException("an answer of operation " + operation + " has fields");
    }
  }
}
