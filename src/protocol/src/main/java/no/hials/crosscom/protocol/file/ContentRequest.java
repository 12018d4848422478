package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks for an operation on a file's content without fields (types 29 and 30): the size of the
 * server's buffer, the end of reading, or an unknown operation, which a server answers too.
 *
 * @param id u16, echoed in the answer
 * @param type u8; {@link MessageType#WRITE_CONTENT} or {@link MessageType#READ_CONTENT}
 * @param operation u8; {@link ContentOperation#SIZE}, {@link ContentOperation#END} of reading only,
 *     or unknown
 */
public record ContentRequest(int id, MessageType type, Code<ContentOperation> operation)
    implements FileRequest {

  /** Checks the ranges. */
  public ContentRequest {
    Ranges.u16("id", id);
    Ranges.type(type, MessageType.WRITE_CONTENT, MessageType.READ_CONTENT);
    Ranges.u8("operation", operation.number());
    if (operation.is(ContentOperation.BEGIN)
        || operation.is(ContentOperation.DATA)
        || (operation.is(ContentOperation.END) && type == MessageType.WRITE_CONTENT)) {
      throw new IllegalArgumentException("operation " + operation + " has fields in " + type);
    }
  }
}
