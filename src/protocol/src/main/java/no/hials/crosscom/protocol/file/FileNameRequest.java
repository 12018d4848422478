package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks for another form of a file's name (types 27 and 28): {@code path}.
 *
 * @param id u16, echoed in the answer
 * @param type u8; {@link MessageType#FULL_NAME} or {@link MessageType#KRC_NAME}
 * @param path WSTRING: u16 count of characters and UTF-16, little-endian; 32,766 at most
 */
public record FileNameRequest(int id, MessageType type, String path) implements FileRequest {
  /** Checks the ranges. */
  public FileNameRequest {
    Ranges.u16("id", id);
    Ranges.type(type, MessageType.FULL_NAME, MessageType.KRC_NAME);
    Ranges.frame("path", 1 + Ranges.wide(path));
  }
}
