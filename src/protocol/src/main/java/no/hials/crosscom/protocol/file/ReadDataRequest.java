package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks for a part of a file (c3-bridge.md, type 30): {@code 02, offset, size}.
 *
 * @param id u16, echoed in the answer
 * @param offset u32; where in the file the part begins
 * @param size u32; how many bytes at most, of which an answer has 64,512 at most (c3-bridge.md,
 *     "Common to all messages")
 */
public record ReadDataRequest(int id, long offset, long size) implements FileRequest {
  /** Asks for as many bytes as fit into an answer. */
  public static final long AS_MUCH_AS_FITS = 0xFFFF_FFFFL;

  /** Checks the ranges. */
  public ReadDataRequest {
    Ranges.u16("id", id);
    Ranges.u32("offset", offset);
    Ranges.u32("size", size);
  }

  @Override
  public MessageType type() {
    return MessageType.READ_CONTENT;
  }
}
