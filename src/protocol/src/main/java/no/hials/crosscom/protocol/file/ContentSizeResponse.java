package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers an operation on a file's content with the size of the server's buffer (types 29 and 30):
 * {@code operation, size}.
 *
 * @param id u16, of the request
 * @param type u8; {@link MessageType#WRITE_CONTENT} or {@link MessageType#READ_CONTENT}
 * @param operation u8; {@link ContentOperation#BEGIN} or {@link ContentOperation#SIZE}
 * @param size u32, in bytes
 * @param tail the end of the answer
 */
public record ContentSizeResponse(
    int id, MessageType type, ContentOperation operation, long size, Tail tail)
    implements TypedResponse {

  /** Checks the ranges. */
  public ContentSizeResponse {
    Ranges.u16("id", id);
    Ranges.type(type, MessageType.WRITE_CONTENT, MessageType.READ_CONTENT);
    if (!isFor(Code.of(operation))) {
      throw new IllegalArgumentException("operation must be BEGIN or SIZE, is " + operation);
    }
    Ranges.u32("size", size);
  }

  static boolean isFor(Code<ContentOperation> operation) {
    return operation.is(ContentOperation.BEGIN) || operation.is(ContentOperation.SIZE);
  }
}
