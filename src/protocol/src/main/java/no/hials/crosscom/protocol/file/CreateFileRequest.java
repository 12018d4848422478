package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.code.ModulePart;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks to create a file, a module or a directory (type 22): {@code itemType, parts, always, name,
 * template}.
 *
 * @param id u16, echoed in the answer
 * @param itemType u16
 * @param parts u8; the parts of a module
 * @param always u8, 0 or 1; whether to create it if it exists
 * @param name WSTRING
 * @param template WSTRING; the file to copy the content from, or empty. Name and template have
 *     32,763 characters together at most
 */
public record CreateFileRequest(
    int id,
    Code<ItemType> itemType,
    Flags<ModulePart> parts,
    boolean always,
    String name,
    String template)
    implements FileRequest {
  /** Checks the ranges. */
  public CreateFileRequest {
    Ranges.u16("id", id);
    Ranges.u16("item type", itemType.number());
    Ranges.u8("parts", parts.bits());
    Ranges.frame("name and template", 1 + 2 + 1 + 1 + Ranges.wide(name) + Ranges.wide(template));
  }
}
