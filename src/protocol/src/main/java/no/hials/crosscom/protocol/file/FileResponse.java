package no.hials.crosscom.protocol.file;

import java.util.List;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.file.FileRequest.FilePropertiesRequest;
import no.hials.crosscom.protocol.file.FileRequest.ListDirectoryRequest;
import no.hials.crosscom.protocol.file.FileRequest.ReadDataRequest;
import no.hials.crosscom.protocol.file.FileRequest.WriteDataRequest;
import no.hials.crosscom.protocol.internal.Ranges;

/** Answers a {@link FileRequest} with more than a tail. */
public sealed interface FileResponse extends TypedResponse {

  /**
   * Answers {@link ListDirectoryRequest} (type 21): {@code count u16, items, count u16, infos}.
   *
   * @param id u16, of the request
   * @param items WSTRING each; the names
   * @param infos WSTRING each, type, attributes and size, such as {@code 32,32,21}; one an item, or
   *     none if {@link no.hials.crosscom.protocol.code.ListFlag#LONG} was not set
   * @param tail the end of the answer
   */
  record ListDirectoryResponse(int id, List<String> items, List<String> infos, Tail tail)
      implements FileResponse {
    /** Checks the ranges. */
    public ListDirectoryResponse {
      items = List.copyOf(items);
      infos = List.copyOf(infos);
      Ranges.u16("id", id);
      Ranges.frame(
          "items and infos", 1 + 2 + Ranges.wide(items) + 2 + Ranges.wide(infos) + Tail.LENGTH);
    }
  }

  /**
   * Answers {@link FilePropertiesRequest} (type 26).
   *
   * @param id u16, of the request
   * @param properties 56 bytes and WSTRING; {@link FileProperties#NONE} if the access failed
   * @param tail the end of the answer
   */
  record FilePropertiesResponse(int id, FileProperties properties, Tail tail)
      implements FileResponse {
    /** Checks the ranges. */
    public FilePropertiesResponse {
      Ranges.u16("id", id);
      Ranges.frame(
          "name", 1 + FileProperties.FIXED_LENGTH + Ranges.wide(properties.name()) + Tail.LENGTH);
    }
  }

  /**
   * Answers an operation on a file's content with the size of the server's buffer (types 29 and
   * 30): {@code operation, size}.
   *
   * @param id u16, of the request
   * @param type u8; {@link MessageType#WRITE_CONTENT} or {@link MessageType#READ_CONTENT}
   * @param operation u8; {@link ContentOperation#BEGIN} or {@link ContentOperation#SIZE}
   * @param size u32, in bytes
   * @param tail the end of the answer
   */
  record ContentSizeResponse(
      int id, MessageType type, ContentOperation operation, long size, Tail tail)
      implements FileResponse {

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

  /**
   * Answers {@link WriteDataRequest} (type 29): {@code 02, offset, written}.
   *
   * @param id u16, of the request
   * @param offset u32, of the request
   * @param written u32; the number of bytes accepted: those within the announced size
   * @param tail the end of the answer
   */
  record WriteDataResponse(int id, long offset, long written, Tail tail) implements FileResponse {
    /** Checks the ranges. */
    public WriteDataResponse {
      Ranges.u16("id", id);
      Ranges.u32("offset", offset);
      Ranges.u32("written", written);
    }
  }

  /**
   * Answers {@link ReadDataRequest} (type 30): {@code 02, offset, size u32, data}.
   *
   * @param id u16, of the request
   * @param offset u32, of the request
   * @param data u32 count and bytes; 65,522 at most; a server sends 64,512 at most
   * @param tail the end of the answer
   */
  record ReadDataResponse(int id, long offset, Bytes data, Tail tail) implements FileResponse {
    /** Checks the ranges. */
    public ReadDataResponse {
      Ranges.u16("id", id);
      Ranges.u32("offset", offset);
      Ranges.frame("data", 1 + 1 + 4 + 4 + data.size() + Tail.LENGTH);
    }
  }

  /**
   * Answers an operation on a file's content with only its number (types 29 and 30): the end, or a
   * failed operation.
   *
   * @param id u16, of the request
   * @param type u8; {@link MessageType#WRITE_CONTENT} or {@link MessageType#READ_CONTENT}
   * @param operation u8, of the request, known or not
   * @param tail the end of the answer; a failure if the answers of the operation have fields
   */
  record ContentResponse(int id, MessageType type, Code<ContentOperation> operation, Tail tail)
      implements FileResponse {

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
}
