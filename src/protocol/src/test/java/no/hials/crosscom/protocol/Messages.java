package no.hials.crosscom.protocol;

import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import no.hials.crosscom.protocol.code.BuildType;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.EditMode;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.FileProperty;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.code.ListFlag;
import no.hials.crosscom.protocol.code.ModulePart;
import no.hials.crosscom.protocol.code.MotionType;
import no.hials.crosscom.protocol.code.PendantKey;
import no.hials.crosscom.protocol.code.ProgramCommand;
import no.hials.crosscom.protocol.code.WireCode;

/** Arbitrary messages of every type: those that KUKAVARPROXY knows, and those of C3 Bridge. */
final class Messages {
  private Messages() {}

  static Arbitrary<Request> requests() {
    return Arbitraries.oneOf(
        Combinators.combine(u16(), text()).as(ReadRequest::new),
        Combinators.combine(u16(), text(), text()).as(WriteRequest::new),
        Combinators.combine(u16(), text()).as(ReadArrayRequest::new),
        Combinators.combine(u16(), text(), words()).as(WriteArrayRequest::new));
  }

  static Arbitrary<Response> responses() {
    return Arbitraries.oneOf(
        Combinators.combine(u16(), text(), tail()).as(ReadResponse::new),
        Combinators.combine(u16(), text(), tail()).as(WriteResponse::new),
        Combinators.combine(u16(), words(), tail()).as(ReadArrayResponse::new),
        Combinators.combine(u16(), text(), tail()).as(WriteArrayResponse::new),
        u16().map(EmptyResponse::new));
  }

  static Arbitrary<Request> c3Requests() {
    return Arbitraries.oneOf(c3VariableRequests(), c3FileRequests(), c3ContentRequests());
  }

  private static Arbitrary<Request> c3VariableRequests() {
    return Arbitraries.oneOf(
        Combinators.combine(u16(), text()).as(ReadRequest::new),
        Combinators.combine(u16(), text(), text()).as(WriteRequest::new),
        Combinators.combine(u16(), wide()).as(ReadUtf16Request::new),
        Combinators.combine(u16(), wide(), wide()).as(WriteUtf16Request::new),
        Combinators.combine(u16(), wide().list().ofMaxSize(20)).as(ReadMultipleRequest::new),
        Combinators.combine(u16(), assignments()).as(WriteMultipleRequest::new),
        Combinators.combine(u16(), command(false), interpreter()).as(ProgramControlRequest::new),
        Combinators.combine(u16(), command(true), interpreter(), wide(), wide(), bool())
            .as(ProgramSelectRequest::new),
        Combinators.combine(u16(), code(MotionType.class, u8()), wide()).as(MotionRequest::new),
        Combinators.combine(u16(), code(PendantKey.class, u8()), i32(), i32(), bool(), bool())
            .as(PendantKeyRequest::new),
        Combinators.combine(
                u16(),
                Arbitraries.of(
                    MessageType.INFORMATION, MessageType.FEATURES, MessageType.CONFIRM_ALL))
            .as(PlainRequest::new),
        Combinators.combine(u16(), u32(), wide().list().ofMaxSize(20))
            .as(BenchmarkReadRequest::new),
        Combinators.combine(u16(), u32(), assignments()).as(BenchmarkWriteRequest::new));
  }

  private static Arbitrary<Request> c3FileRequests() {
    return Arbitraries.oneOf(
        Combinators.combine(u16(), flags(FileAttribute.class), flags(FileAttribute.class), wide())
            .as(SetAttributesRequest::new),
        Combinators.combine(u16(), flags(ItemType.class), flags(ListFlag.class), wide())
            .as(ListDirectoryRequest::new),
        Combinators.combine(
                u16(),
                code(ItemType.class, u16()),
                u8().map(bits -> new Flags<>(ModulePart.class, bits)),
                bool(),
                wide(),
                wide())
            .as(CreateFileRequest::new),
        Combinators.combine(u16(), bool(), wide()).as(DeleteFileRequest::new),
        Combinators.combine(
                u16(),
                Arbitraries.of(MessageType.COPY_FILE, MessageType.MOVE_FILE),
                flags(CopyFlag.class),
                wide(),
                wide())
            .as(CopyFileRequest::new),
        Combinators.combine(u16(), flags(FileProperty.class), wide())
            .as(FilePropertiesRequest::new),
        Combinators.combine(
                u16(), Arbitraries.of(MessageType.FULL_NAME, MessageType.KRC_NAME), wide())
            .as(FileNameRequest::new));
  }

  private static Arbitrary<Request> c3ContentRequests() {
    return Arbitraries.oneOf(
        Combinators.combine(u16(), u32()).as(BeginWriteRequest::new),
        Combinators.combine(u16(), u32(), bytes()).as(WriteDataRequest::new),
        Combinators.combine(u16(), flags(CopyFlag.class), wide()).as(EndWriteRequest::new),
        Combinators.combine(u16(), flags(CopyFlag.class), wide()).as(BeginReadRequest::new),
        Combinators.combine(u16(), u32(), u32()).as(ReadDataRequest::new),
        Combinators.combine(u16(), content(), operation(0, 3, 5, 255)).as(ContentRequest::new),
        u16()
            .map(
                id ->
                    new ContentRequest(
                        id, MessageType.READ_CONTENT, Code.of(ContentOperation.END))));
  }

  static Arbitrary<Response> c3Responses() {
    return Arbitraries.oneOf(c3VariableResponses(), c3FileResponses(), c3FailedResponses());
  }

  private static Arbitrary<Response> c3VariableResponses() {
    return Arbitraries.oneOf(
        Combinators.combine(u16(), text(), tail()).as(ReadResponse::new),
        Combinators.combine(u16(), text(), tail()).as(WriteResponse::new),
        u16().map(EmptyResponse::new),
        Combinators.combine(
                u16(),
                Arbitraries.of(
                    MessageType.READ_UTF16,
                    MessageType.WRITE_UTF16,
                    MessageType.FULL_NAME,
                    MessageType.KRC_NAME),
                wide(),
                tail())
            .as(TextResponse::new),
        Combinators.combine(
                u16(),
                Arbitraries.of(MessageType.READ_MULTIPLE, MessageType.WRITE_MULTIPLE),
                Combinators.combine(code(ErrorCode.class, u8()), wide())
                    .as(AccessResult::new)
                    .list()
                    .ofMaxSize(20),
                tail())
            .as(MultipleResponse::new),
        Combinators.combine(u16(), code(ProgramCommand.class, u8()), tail())
            .as(ProgramControlResponse::new),
        Combinators.combine(u16(), code(MotionType.class, u8()), tail()).as(MotionResponse::new),
        Combinators.combine(u16(), code(PendantKey.class, u8()), tail())
            .as(PendantKeyResponse::new),
        Combinators.combine(u16(), information(), tail()).as(InformationResponse::new),
        Combinators.combine(u16(), u8().set().map(Features::new), tail()).as(FeaturesResponse::new),
        Combinators.combine(u16(), bool(), u8(), u32(), u32(), u32(), u32(), tail())
            .as(BenchmarkResponse::new));
  }

  private static Arbitrary<Response> c3FileResponses() {
    return Arbitraries.oneOf(
        Combinators.combine(u16(), wide().list().ofMaxSize(20), wide().list().ofMaxSize(20), tail())
            .as(ListDirectoryResponse::new),
        Combinators.combine(u16(), properties(), tail()).as(FilePropertiesResponse::new),
        Combinators.combine(
                u16(),
                content(),
                Arbitraries.of(ContentOperation.BEGIN, ContentOperation.SIZE),
                u32(),
                tail())
            .as(ContentSizeResponse::new),
        Combinators.combine(u16(), u32(), u32(), tail()).as(WriteDataResponse::new),
        Combinators.combine(u16(), u32(), bytes(), tail()).as(ReadDataResponse::new),
        Combinators.combine(u16(), content(), operation(0, 4, 5, 255), tail())
            .as(ContentResponse::new),
        Combinators.combine(
                u16(),
                Arbitraries.of(
                    MessageType.SET_ATTRIBUTES,
                    MessageType.CREATE_FILE,
                    MessageType.DELETE_FILE,
                    MessageType.COPY_FILE,
                    MessageType.MOVE_FILE,
                    MessageType.CONFIRM_ALL),
                tail())
            .as(PlainResponse::new));
  }

  private static Arbitrary<Response> c3FailedResponses() {
    Arbitrary<Tail> failed = u16().map(code -> new Tail(code, 0));
    return Arbitraries.oneOf(
        Combinators.combine(u16(), content(), operation(1, 2, 3, 4), failed)
            .as(ContentResponse::new),
        Combinators.combine(
                u16(),
                Arbitraries.of(MessageType.class)
                    .filter(type -> !type.isKnownTo(ServerType.KUKAVARPROXY)),
                failed)
            .as(PlainResponse::new));
  }

  private static Arbitrary<Code<ProgramCommand>> command(boolean selects) {
    return code(ProgramCommand.class, selects ? Arbitraries.of(5, 6) : u8())
        .filter(command -> ProgramLayout.selects(command) == selects);
  }

  private static Arbitrary<Code<Interpreter>> interpreter() {
    return code(Interpreter.class, Arbitraries.integers().between(-32768, 32767));
  }

  private static Arbitrary<MessageType> content() {
    return Arbitraries.of(MessageType.WRITE_CONTENT, MessageType.READ_CONTENT);
  }

  private static Arbitrary<Code<ContentOperation>> operation(Integer... numbers) {
    return code(ContentOperation.class, Arbitraries.of(numbers));
  }

  private static Arbitrary<ServerInformation> information() {
    Arbitrary<SystemTime> time =
        Combinators.combine(u16(), u16(), u16(), u16(), u16(), u16(), u16(), u16())
            .as(SystemTime::new);
    return Combinators.combine(u8(), u8(), code(BuildType.class, u8()), time, wide())
        .as(ServerInformation::new);
  }

  private static Arbitrary<FileProperties> properties() {
    Arbitrary<ItemTime> time =
        Combinators.combine(Arbitraries.longs(), i32()).as(ItemTime::ofTicks);
    return Combinators.combine(
            code(ItemType.class, i32()),
            Arbitraries.longs().between(0, Long.MAX_VALUE),
            flags(FileAttribute.class),
            time,
            time,
            time,
            code(EditMode.class, i32()),
            wide())
        .as(FileProperties::new);
  }

  private static Arbitrary<List<Assignment>> assignments() {
    return Combinators.combine(wide(), wide()).as(Assignment::new).list().ofMaxSize(20);
  }

  private static <E extends Enum<E> & WireCode> Arbitrary<Code<E>> code(
      Class<E> type, Arbitrary<Integer> number) {
    return number.map(n -> new Code<>(type, n));
  }

  private static <E extends Enum<E> & WireCode> Arbitrary<Flags<E>> flags(Class<E> type) {
    return i32().map(bits -> new Flags<>(type, bits));
  }

  private static Arbitrary<Boolean> bool() {
    return Arbitraries.of(true, false);
  }

  private static Arbitrary<Bytes> bytes() {
    return Arbitraries.bytes().array(byte[].class).ofMaxSize(600).map(Bytes::of);
  }

  private static Arbitrary<String> wide() {
    return Arbitraries.strings().all().ofMaxLength(60);
  }

  private static Arbitrary<Integer> u8() {
    return Arbitraries.integers().between(0, 255);
  }

  private static Arbitrary<Integer> i32() {
    return Arbitraries.integers();
  }

  private static Arbitrary<Long> u32() {
    return Arbitraries.longs().between(0, 0xFFFF_FFFFL);
  }

  private static Arbitrary<Integer> u16() {
    return Arbitraries.integers().between(0, 65535);
  }

  private static Arbitrary<String> text() {
    return Arbitraries.strings().withCharRange('\0', '\u00FF').ofMaxLength(600);
  }

  private static Arbitrary<List<Integer>> words() {
    return u16().list().ofMaxSize(300);
  }

  private static Arbitrary<Tail> tail() {
    return Combinators.combine(u16(), Arbitraries.integers().between(0, 255)).as(Tail::new);
  }
}
