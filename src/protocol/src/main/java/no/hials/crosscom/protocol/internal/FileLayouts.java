package no.hials.crosscom.protocol.internal;

import java.util.List;
import no.hials.crosscom.protocol.MalformedFrameException;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.EditMode;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.FileProperty;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.code.ListFlag;
import no.hials.crosscom.protocol.code.ModulePart;
import no.hials.crosscom.protocol.file.Bytes;
import no.hials.crosscom.protocol.file.FileProperties;
import no.hials.crosscom.protocol.file.FileRequest.BeginReadRequest;
import no.hials.crosscom.protocol.file.FileRequest.BeginWriteRequest;
import no.hials.crosscom.protocol.file.FileRequest.ContentRequest;
import no.hials.crosscom.protocol.file.FileRequest.CopyFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.CreateFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.DeleteFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.EndWriteRequest;
import no.hials.crosscom.protocol.file.FileRequest.FileNameRequest;
import no.hials.crosscom.protocol.file.FileRequest.FilePropertiesRequest;
import no.hials.crosscom.protocol.file.FileRequest.ListDirectoryRequest;
import no.hials.crosscom.protocol.file.FileRequest.ReadDataRequest;
import no.hials.crosscom.protocol.file.FileRequest.SetAttributesRequest;
import no.hials.crosscom.protocol.file.FileRequest.WriteDataRequest;
import no.hials.crosscom.protocol.file.FileResponse.ContentResponse;
import no.hials.crosscom.protocol.file.FileResponse.ContentSizeResponse;
import no.hials.crosscom.protocol.file.FileResponse.FilePropertiesResponse;
import no.hials.crosscom.protocol.file.FileResponse.ListDirectoryResponse;
import no.hials.crosscom.protocol.file.FileResponse.ReadDataResponse;
import no.hials.crosscom.protocol.file.FileResponse.WriteDataResponse;
import no.hials.crosscom.protocol.file.ItemTime;

/** The layouts of the messages about files: types 20 to 30. */
final class FileLayouts {
  private FileLayouts() {}

  static void addTo(Layouts all) {
    addChanges(all);
    addQuestions(all);
    addWriting(all);
    addReading(all);
    addContentAnswers(all);
  }

  private static void addChanges(Layouts all) {
    all.request(
        MessageType.SET_ATTRIBUTES,
        SetAttributesRequest.class,
        (m, out) -> out.i32(m.attributes().bits()).i32(m.mask().bits()).wide(m.name()),
        (id, in) ->
            new SetAttributesRequest(
                id, attributes(in, "attributes"), attributes(in, "mask"), in.wide("name")));
    all.plainAnswer(MessageType.SET_ATTRIBUTES);
    all.request(
        MessageType.CREATE_FILE,
        CreateFileRequest.class,
        (m, out) ->
            out.u16(m.itemType().number())
                .u8(m.parts().bits())
                .bool(m.always())
                .wide(m.name())
                .wide(m.template()),
        (id, in) ->
            new CreateFileRequest(
                id,
                new Code<>(ItemType.class, in.u16("item type")),
                new Flags<>(ModulePart.class, in.u8("parts")),
                in.bool("always"),
                in.wide("name"),
                in.wide("template")));
    all.plainAnswer(MessageType.CREATE_FILE);
    all.request(
        MessageType.DELETE_FILE,
        DeleteFileRequest.class,
        (m, out) -> out.bool(m.always()).wide(m.name()),
        (id, in) -> new DeleteFileRequest(id, in.bool("always"), in.wide("name")));
    all.plainAnswer(MessageType.DELETE_FILE);
    all.writer(
        CopyFileRequest.class,
        (m, out) -> out.i32(m.flags().bits()).wide(m.source()).wide(m.destination()));
    for (MessageType type : List.of(MessageType.COPY_FILE, MessageType.MOVE_FILE)) {
      all.request(
          type,
          (id, in) ->
              new CopyFileRequest(
                  id, type, copyFlags(in), in.wide("source"), in.wide("destination")));
      all.plainAnswer(type);
    }
  }

  private static void addQuestions(Layouts all) {
    all.request(
        MessageType.LIST_DIRECTORY,
        ListDirectoryRequest.class,
        (m, out) -> out.i32(m.types().bits()).i32(m.flags().bits()).wide(m.path()),
        (id, in) ->
            new ListDirectoryRequest(
                id,
                new Flags<>(ItemType.class, in.i32("types")),
                new Flags<>(ListFlag.class, in.i32("flags")),
                in.wide("path")));
    all.answer(
        MessageType.LIST_DIRECTORY,
        ListDirectoryResponse.class,
        (m, out) -> {
          out.u16(m.items().size());
          m.items().forEach(out::wide);
          out.u16(m.infos().size());
          m.infos().forEach(out::wide);
        },
        (id, in, tail) ->
            new ListDirectoryResponse(
                id,
                in.wides(in.u16("item count"), "item"),
                in.wides(in.u16("info count"), "info"),
                tail));
    all.request(
        MessageType.FILE_PROPERTIES,
        FilePropertiesRequest.class,
        (m, out) -> out.i32(m.properties().bits()).wide(m.name()),
        (id, in) ->
            new FilePropertiesRequest(
                id, new Flags<>(FileProperty.class, in.i32("properties")), in.wide("name")));
    all.answer(
        MessageType.FILE_PROPERTIES,
        FilePropertiesResponse.class,
        (m, out) -> write(m.properties(), out),
        (id, in, tail) -> new FilePropertiesResponse(id, properties(in), tail));
    all.writer(FileNameRequest.class, (m, out) -> out.wide(m.path()));
    for (MessageType type : List.of(MessageType.FULL_NAME, MessageType.KRC_NAME)) {
      all.request(type, (id, in) -> new FileNameRequest(id, type, in.wide("path")));
      all.textAnswer(type);
    }
  }

  private static void write(FileProperties properties, FieldWriter out) {
    out.i32(properties.itemType().number())
        .lowHigh(properties.size())
        .i32(properties.attributes().bits());
    write(properties.created(), out);
    write(properties.accessed(), out);
    write(properties.modified(), out);
    out.i32(properties.editMode().number()).wide(properties.name());
  }

  private static FileProperties properties(FieldReader in) throws MalformedFrameException {
    return new FileProperties(
        new Code<>(ItemType.class, in.i32("item type")),
        size(in),
        attributes(in, "attributes"),
        time(in, "creation time"),
        time(in, "access time"),
        time(in, "modification time"),
        new Code<>(EditMode.class, in.i32("edit mode")),
        in.wide("name"));
  }

  private static long size(FieldReader in) throws MalformedFrameException {
    long size = in.lowHigh("size");
    if (size < 0) {
      throw in.malformed("size must not be negative, is " + size);
    }
    return size;
  }

  private static void write(ItemTime time, FieldWriter out) {
    out.lowHigh(time.ticks()).i32(time.biasMinutes());
  }

  private static ItemTime time(FieldReader in, String field) throws MalformedFrameException {
    return ItemTime.ofTicks(in.lowHigh(field), in.i32(field + " bias"));
  }

  private static Flags<FileAttribute> attributes(FieldReader in, String field)
      throws MalformedFrameException {
    return new Flags<>(FileAttribute.class, in.i32(field));
  }

  private static Flags<CopyFlag> copyFlags(FieldReader in) throws MalformedFrameException {
    return new Flags<>(CopyFlag.class, in.i32("flags"));
  }

  // types 29 and 30, with a layout for each operation

  private static void addWriting(Layouts all) {
    all.request(MessageType.WRITE_CONTENT, FileLayouts::readWriting);
    all.writer(
        MessageType.WRITE_CONTENT,
        BeginWriteRequest.class,
        (m, out) -> out.u8(ContentOperation.BEGIN.code()).u32(m.size()));
    all.writer(
        MessageType.WRITE_CONTENT,
        WriteDataRequest.class,
        (m, out) -> writeData(m.offset(), m.data(), out));
    all.writer(
        MessageType.WRITE_CONTENT,
        EndWriteRequest.class,
        (m, out) -> out.u8(ContentOperation.END.code()).i32(m.flags().bits()).wide(m.name()));
    all.writer(ContentRequest.class, (m, out) -> out.u8(m.operation().number()));
  }

  private static void addReading(Layouts all) {
    all.request(MessageType.READ_CONTENT, FileLayouts::readReading);
    all.writer(
        MessageType.READ_CONTENT,
        BeginReadRequest.class,
        (m, out) -> out.u8(ContentOperation.BEGIN.code()).i32(m.flags().bits()).wide(m.name()));
    all.writer(
        MessageType.READ_CONTENT,
        ReadDataRequest.class,
        (m, out) -> out.u8(ContentOperation.DATA.code()).u32(m.offset()).u32(m.size()));
  }

  private static void addContentAnswers(Layouts all) {
    for (MessageType type : List.of(MessageType.WRITE_CONTENT, MessageType.READ_CONTENT)) {
      all.answer(type, (id, in, tail) -> readAnswer(id, type, in, tail));
    }
    all.writer(ContentSizeResponse.class, (m, out) -> out.u8(m.operation().code()).u32(m.size()));
    all.writer(
        MessageType.WRITE_CONTENT,
        WriteDataResponse.class,
        (m, out) -> out.u8(ContentOperation.DATA.code()).u32(m.offset()).u32(m.written()));
    all.writer(
        MessageType.READ_CONTENT,
        ReadDataResponse.class,
        (m, out) -> writeData(m.offset(), m.data(), out));
    all.writer(ContentResponse.class, (m, out) -> out.u8(m.operation().number()));
  }

  private static Code<ContentOperation> operation(FieldReader in) throws MalformedFrameException {
    return new Code<>(ContentOperation.class, in.u8("operation"));
  }

  private static void writeData(long offset, Bytes data, FieldWriter out) {
    out.u8(ContentOperation.DATA.code()).u32(offset).u32(data.size()).bytes(data);
  }

  private static Bytes data(FieldReader in) throws MalformedFrameException {
    return in.bytes(in.u32("data size"), "data");
  }

  private static Request readWriting(int id, FieldReader in) throws MalformedFrameException {
    Code<ContentOperation> operation = operation(in);
    if (operation.is(ContentOperation.BEGIN)) {
      return new BeginWriteRequest(id, in.u32("size"));
    }
    if (operation.is(ContentOperation.DATA)) {
      return new WriteDataRequest(id, in.u32("offset"), data(in));
    }
    if (operation.is(ContentOperation.END)) {
      return new EndWriteRequest(id, copyFlags(in), in.wide("name"));
    }
    return new ContentRequest(id, MessageType.WRITE_CONTENT, operation);
  }

  private static Request readReading(int id, FieldReader in) throws MalformedFrameException {
    Code<ContentOperation> operation = operation(in);
    if (operation.is(ContentOperation.BEGIN)) {
      return new BeginReadRequest(id, copyFlags(in), in.wide("name"));
    }
    if (operation.is(ContentOperation.DATA)) {
      return new ReadDataRequest(id, in.u32("offset"), in.u32("size"));
    }
    return new ContentRequest(id, MessageType.READ_CONTENT, operation);
  }

  private static TypedResponse readAnswer(int id, MessageType type, FieldReader in, Tail tail)
      throws MalformedFrameException {
    Code<ContentOperation> operation = operation(in);
    if (in.isEmpty() && !tail.success()) {
      return new ContentResponse(id, type, operation, tail);
    }
    if (operation.is(ContentOperation.BEGIN)) {
      return new ContentSizeResponse(id, type, ContentOperation.BEGIN, in.u32("size"), tail);
    }
    if (operation.is(ContentOperation.SIZE)) {
      return new ContentSizeResponse(id, type, ContentOperation.SIZE, in.u32("size"), tail);
    }
    if (!operation.is(ContentOperation.DATA)) {
      return new ContentResponse(id, type, operation, tail);
    }
    return type == MessageType.WRITE_CONTENT
        ? new WriteDataResponse(id, in.u32("offset"), in.u32("written"), tail)
        : new ReadDataResponse(id, in.u32("offset"), data(in), tail);
  }
}
