package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.code.FileProperty;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks for a file's properties (type 26): {@code properties, name}.
 *
 * @param id u16, echoed in the answer
 * @param properties i32; the properties that are asked for
 * @param name WSTRING; 32,764 characters at most
 */
public record FilePropertiesRequest(int id, Flags<FileProperty> properties, String name)
    implements FileRequest {
  /** Checks the ranges. */
  public FilePropertiesRequest {
    Ranges.u16("id", id);
    Ranges.frame("name", 1 + 4 + Ranges.wide(name));
  }
}
