package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks to copy or to move a file (types 24 and 25): {@code flags, source, destination}.
 *
 * @param id u16, echoed in the answer
 * @param type u8; {@link MessageType#COPY_FILE} or {@link MessageType#MOVE_FILE}
 * @param flags i32
 * @param source WSTRING
 * @param destination WSTRING; source and destination have 32,763 characters together at most
 */
public record CopyFileRequest(
    int id, MessageType type, Flags<CopyFlag> flags, String source, String destination)
    implements FileRequest {
  /** Checks the ranges. */
  public CopyFileRequest {
    Ranges.u16("id", id);
    Ranges.type(type, MessageType.COPY_FILE, MessageType.MOVE_FILE);
    Ranges.frame("source and destination", 5 + Ranges.wide(source) + Ranges.wide(destination));
  }
}
