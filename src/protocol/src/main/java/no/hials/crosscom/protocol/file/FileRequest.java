package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.FileProperty;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.code.ListFlag;
import no.hials.crosscom.protocol.code.ModulePart;
import no.hials.crosscom.protocol.internal.Ranges;

/** Asks about the files of the controller, or asks to change them. */
public sealed interface FileRequest extends Request {

  /**
   * Asks to change a file's attributes (type 20): {@code attributes, mask, name}.
   *
   * @param id u16, echoed in the answer
   * @param attributes i32; the new values of the attributes in {@code mask}
   * @param mask i32; the attributes to change
   * @param name WSTRING; 32,762 characters at most
   */
  record SetAttributesRequest(
      int id, Flags<FileAttribute> attributes, Flags<FileAttribute> mask, String name)
      implements FileRequest {
    /** Checks the ranges. */
    public SetAttributesRequest {
      Ranges.u16("id", id);
      Ranges.frame("name", 1 + 4 + 4 + Ranges.wide(name));
    }
  }

  /**
   * Asks for the items of a directory (type 21): {@code types, flags, path}.
   *
   * @param id u16, echoed in the answer
   * @param types i32; the kinds of items that are asked for, or none for all
   * @param flags i32
   * @param path WSTRING; 32,762 characters at most
   */
  record ListDirectoryRequest(int id, Flags<ItemType> types, Flags<ListFlag> flags, String path)
      implements FileRequest {
    /** Checks the ranges. */
    public ListDirectoryRequest {
      Ranges.u16("id", id);
      Ranges.frame("path", 1 + 4 + 4 + Ranges.wide(path));
    }
  }

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
  record CreateFileRequest(
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

  /**
   * Asks to delete a file (type 23): {@code always, name}.
   *
   * @param id u16, echoed in the answer
   * @param always u8, 0 or 1; whether to delete it if it is read-only
   * @param name WSTRING; 32,765 characters at most
   */
  record DeleteFileRequest(int id, boolean always, String name) implements FileRequest {
    /** Checks the ranges. */
    public DeleteFileRequest {
      Ranges.u16("id", id);
      Ranges.frame("name", 1 + 1 + Ranges.wide(name));
    }
  }

  /**
   * Asks to copy or to move a file (types 24 and 25): {@code flags, source, destination}.
   *
   * @param id u16, echoed in the answer
   * @param type u8; {@link MessageType#COPY_FILE} or {@link MessageType#MOVE_FILE}
   * @param flags i32
   * @param source WSTRING
   * @param destination WSTRING; source and destination have 32,763 characters together at most
   */
  record CopyFileRequest(
      int id, MessageType type, Flags<CopyFlag> flags, String source, String destination)
      implements FileRequest {
    /** Checks the ranges. */
    public CopyFileRequest {
      Ranges.u16("id", id);
      Ranges.type(type, MessageType.COPY_FILE, MessageType.MOVE_FILE);
      Ranges.frame("source and destination", 5 + Ranges.wide(source) + Ranges.wide(destination));
    }
  }

  /**
   * Asks for a file's properties (type 26): {@code properties, name}.
   *
   * @param id u16, echoed in the answer
   * @param properties i32; the properties that are asked for
   * @param name WSTRING; 32,764 characters at most
   */
  record FilePropertiesRequest(int id, Flags<FileProperty> properties, String name)
      implements FileRequest {
    /** Checks the ranges. */
    public FilePropertiesRequest {
      Ranges.u16("id", id);
      Ranges.frame("name", 1 + 4 + Ranges.wide(name));
    }
  }

  /**
   * Asks for another form of a file's name (types 27 and 28): {@code path}.
   *
   * @param id u16, echoed in the answer
   * @param type u8; {@link MessageType#FULL_NAME} or {@link MessageType#KRC_NAME}
   * @param path WSTRING: u16 count of characters and UTF-16, little-endian; 32,766 at most
   */
  record FileNameRequest(int id, MessageType type, String path) implements FileRequest {
    /** Checks the ranges. */
    public FileNameRequest {
      Ranges.u16("id", id);
      Ranges.type(type, MessageType.FULL_NAME, MessageType.KRC_NAME);
      Ranges.frame("path", 1 + Ranges.wide(path));
    }
  }

  /**
   * Announces a file (type 29): {@code 01, size}.
   *
   * @param id u16, echoed in the answer
   * @param size u32; the size of the whole file in bytes
   */
  record BeginWriteRequest(int id, long size) implements FileRequest {
    /** Checks the ranges. */
    public BeginWriteRequest {
      Ranges.u16("id", id);
      Ranges.u32("size", size);
    }
  }

  /**
   * Sends a part of a file (type 29): {@code 02, offset, size u32, data}.
   *
   * @param id u16, echoed in the answer
   * @param offset u32; the index of the data in the file
   * @param data u32 count and bytes; 65,525 at most
   */
  record WriteDataRequest(int id, long offset, Bytes data) implements FileRequest {
    /** Checks the ranges. */
    public WriteDataRequest {
      Ranges.u16("id", id);
      Ranges.u32("offset", offset);
      Ranges.frame("data", 1 + 1 + 4 + 4 + data.size());
    }
  }

  /**
   * Asks to store the bytes sent as a file (type 29): {@code 04, flags, name}.
   *
   * @param id u16, echoed in the answer
   * @param flags i32
   * @param name WSTRING; 32,763 characters at most
   */
  record EndWriteRequest(int id, Flags<CopyFlag> flags, String name) implements FileRequest {
    /** Checks the ranges. */
    public EndWriteRequest {
      Ranges.u16("id", id);
      Ranges.frame("name", 1 + 1 + 4 + Ranges.wide(name));
    }
  }

  /**
   * Asks to read a file in parts (type 30): {@code 01, flags, name}. The length of the name is a
   * u16, as the server reads it; its description has a u32
   * (docs/reference/c3-messages.md#file-content-29-and-30).
   *
   * @param id u16, echoed in the answer
   * @param flags i32
   * @param name WSTRING; 32,763 characters at most
   */
  record BeginReadRequest(int id, Flags<CopyFlag> flags, String name) implements FileRequest {
    /** Checks the ranges. */
    public BeginReadRequest {
      Ranges.u16("id", id);
      Ranges.frame("name", 1 + 1 + 4 + Ranges.wide(name));
    }
  }

  /**
   * Asks for a part of a file (type 30): {@code 02, offset, size}.
   *
   * @param id u16, echoed in the answer
   * @param offset u32; the index of the part in the file
   * @param size u32; the largest number of bytes; a server sends 64,512 at most
   */
  record ReadDataRequest(int id, long offset, long size) implements FileRequest {
    /** Asks for as many bytes as fit into an answer. */
    public static final long AS_MUCH_AS_FITS = 0xFFFF_FFFFL;

    /** Checks the ranges. */
    public ReadDataRequest {
      Ranges.u16("id", id);
      Ranges.u32("offset", offset);
      Ranges.u32("size", size);
    }
  }

  /**
   * Asks for an operation on a file's content without fields (types 29 and 30): the size of the
   * server's buffer, the end of reading, or an unknown operation, which a server answers too.
   *
   * @param id u16, echoed in the answer
   * @param type u8; {@link MessageType#WRITE_CONTENT} or {@link MessageType#READ_CONTENT}
   * @param operation u8; {@link ContentOperation#SIZE}, {@link ContentOperation#END} of reading
   *     only, or unknown
   */
  record ContentRequest(int id, MessageType type, Code<ContentOperation> operation)
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
}
