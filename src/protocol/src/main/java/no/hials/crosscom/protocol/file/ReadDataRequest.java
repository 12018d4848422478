package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks for a part of a file (type 30): {@code 02, offset, size}.
 *
 * @param id u16, echoed in the answer
 * @param offset u32; the index of the part in the file
 * @param size u32; the largest number of bytes; a server sends 64,512 at most
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
}
