package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.Flags;

/** The layouts of types 29 and 30, one for each operation. */
final class ContentLayout {
  private ContentLayout() {}

  static Layout<Request> request(MessageType type) {
    return new Layout<>(
        ContentLayout::write,
        (id, in, tail) -> {
          Code<ContentOperation> operation = operation(in);
          return type == MessageType.WRITE_CONTENT
              ? readWriting(id, operation, in)
              : readReading(id, operation, in);
        });
  }

  static Layout<TypedResponse> response(MessageType type) {
    return new Layout<>(
        ContentLayout::write, (id, in, tail) -> readAnswer(id, type, operation(in), in, tail));
  }

  private static Code<ContentOperation> operation(WireBuffer in) throws MalformedFrameException {
    return new Code<>(ContentOperation.class, in.u8("operation"));
  }

  private static void write(Request request, WireBuffer out) {
    if (request instanceof BeginWriteRequest begin) {
      out.u8(ContentOperation.BEGIN.code());
      out.u32(begin.size());
    } else if (request instanceof WriteDataRequest data) {
      write(data.offset(), data.data(), out);
    } else if (request instanceof EndWriteRequest end) {
      out.u8(ContentOperation.END.code());
      write(end.flags(), end.name(), out);
    } else if (request instanceof BeginReadRequest begin) {
      out.u8(ContentOperation.BEGIN.code());
      write(begin.flags(), begin.name(), out);
    } else if (request instanceof ReadDataRequest data) {
      out.u8(ContentOperation.DATA.code());
      out.u32(data.offset());
      out.u32(data.size());
    } else if (request instanceof ContentRequest plain) {
      out.u8(plain.operation().number());
    }
  }

  private static void write(TypedResponse response, WireBuffer out) {
    if (response instanceof ContentSizeResponse size) {
      out.u8(size.operation().code());
      out.u32(size.size());
    } else if (response instanceof WriteDataResponse data) {
      out.u8(ContentOperation.DATA.code());
      out.u32(data.offset());
      out.u32(data.written());
    } else if (response instanceof ReadDataResponse data) {
      write(data.offset(), data.data(), out);
    } else if (response instanceof ContentResponse plain) {
      out.u8(plain.operation().number());
    }
  }

  private static void write(long offset, Bytes data, WireBuffer out) {
    out.u8(ContentOperation.DATA.code());
    out.u32(offset);
    out.u32(data.size());
    out.putBytes(data);
  }

  private static void write(Flags<CopyFlag> flags, String name, WireBuffer out) {
    out.i32(flags.bits());
    out.putWide(name);
  }

  private static Request readWriting(int id, Code<ContentOperation> operation, WireBuffer in)
      throws MalformedFrameException {
    if (operation.is(ContentOperation.BEGIN)) {
      return new BeginWriteRequest(id, in.u32("size"));
    }
    if (operation.is(ContentOperation.DATA)) {
      return new WriteDataRequest(id, in.u32("offset"), data(in));
    }
    if (operation.is(ContentOperation.END)) {
      return new EndWriteRequest(id, flags(in), in.wide("name"));
    }
    return new ContentRequest(id, MessageType.WRITE_CONTENT, operation);
  }

  private static Request readReading(int id, Code<ContentOperation> operation, WireBuffer in)
      throws MalformedFrameException {
    if (operation.is(ContentOperation.BEGIN)) {
      return new BeginReadRequest(id, flags(in), in.wide("name"));
    }
    if (operation.is(ContentOperation.DATA)) {
      return new ReadDataRequest(id, in.u32("offset"), in.u32("size"));
    }
    return new ContentRequest(id, MessageType.READ_CONTENT, operation);
  }

  private static TypedResponse readAnswer(
      int id, MessageType type, Code<ContentOperation> operation, WireBuffer in, Tail tail)
      throws MalformedFrameException {
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

  private static Bytes data(WireBuffer in) throws MalformedFrameException {
    return in.bytes(in.u32("data size"), "data");
  }

  private static Flags<CopyFlag> flags(WireBuffer in) throws MalformedFrameException {
    return new Flags<>(CopyFlag.class, in.i32("flags"));
  }
}
