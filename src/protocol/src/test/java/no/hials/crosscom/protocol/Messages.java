package no.hials.crosscom.protocol;

import static no.hials.crosscom.protocol.Samples.anyOf;
import static no.hials.crosscom.protocol.Samples.list;
import static no.hials.crosscom.protocol.Samples.oneOf;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
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
import no.hials.crosscom.protocol.internal.ProgramLayouts;
import no.hials.crosscom.protocol.program.ProgramRequest.MotionRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.PendantKeyRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramControlRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramSelectRequest;
import no.hials.crosscom.protocol.program.ProgramResponse;
import no.hials.crosscom.protocol.server.Features;
import no.hials.crosscom.protocol.server.ServerInformation;
import no.hials.crosscom.protocol.server.ServerRequest;
import no.hials.crosscom.protocol.server.ServerResponse.FeaturesResponse;
import no.hials.crosscom.protocol.server.ServerResponse.InformationResponse;
import no.hials.crosscom.protocol.server.SystemTime;
import no.hials.crosscom.protocol.variable.AccessResult;
import no.hials.crosscom.protocol.variable.Assignment;
import no.hials.crosscom.protocol.variable.VariableRequest.BenchmarkReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.BenchmarkWriteRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadArrayRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadUtf16Request;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteArrayRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteUtf16Request;
import no.hials.crosscom.protocol.variable.VariableResponse.BenchmarkResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.MultipleResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.ReadArrayResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;

/** Random messages of every type: those that KUKAVARPROXY knows, and those of C3 Bridge. */
final class Messages {
  private Messages() {}

  static Request request(Random r) {
    return oneOf(
        r,
        () -> new ReadRequest(u16(r), text(r)),
        () -> new WriteRequest(u16(r), text(r), text(r)),
        () -> new ReadArrayRequest(u16(r), text(r)),
        () -> new WriteArrayRequest(u16(r), text(r), words(r)));
  }

  static Response response(Random r) {
    return oneOf(
        r,
        () -> new ValueResponse(u16(r), MessageType.READ, text(r), tail(r)),
        () -> new ValueResponse(u16(r), MessageType.WRITE, text(r), tail(r)),
        () -> new ReadArrayResponse(u16(r), words(r), tail(r)),
        () -> new ValueResponse(u16(r), MessageType.WRITE_ARRAY, text(r), tail(r)),
        () -> new EmptyResponse(u16(r)));
  }

  static Request c3Request(Random r) {
    return oneOf(r, () -> c3VariableRequest(r), () -> c3FileRequest(r), () -> c3ContentRequest(r));
  }

  private static Request c3VariableRequest(Random r) {
    return oneOf(
        r,
        () -> new ReadRequest(u16(r), text(r)),
        () -> new WriteRequest(u16(r), text(r), text(r)),
        () -> new ReadUtf16Request(u16(r), wide(r)),
        () -> new WriteUtf16Request(u16(r), wide(r), wide(r)),
        () -> new ReadMultipleRequest(u16(r), list(r, 0, 20, () -> wide(r))),
        () -> new WriteMultipleRequest(u16(r), assignments(r)),
        () -> new ProgramControlRequest(u16(r), plainCommand(r), interpreter(r)),
        () ->
            new ProgramSelectRequest(
                u16(r),
                new Code<>(ProgramCommand.class, anyOf(r, 5, 6)),
                interpreter(r),
                wide(r),
                wide(r),
                r.nextBoolean()),
        () -> new MotionRequest(u16(r), code(MotionType.class, r), wide(r)),
        () ->
            new PendantKeyRequest(
                u16(r),
                code(PendantKey.class, r),
                i32(r),
                i32(r),
                r.nextBoolean(),
                r.nextBoolean()),
        () ->
            new ServerRequest(
                u16(r),
                anyOf(r, MessageType.INFORMATION, MessageType.FEATURES, MessageType.CONFIRM_ALL)),
        () -> new BenchmarkReadRequest(u16(r), u32(r), list(r, 0, 20, () -> wide(r))),
        () -> new BenchmarkWriteRequest(u16(r), u32(r), assignments(r)));
  }

  private static Request c3FileRequest(Random r) {
    return oneOf(
        r,
        () ->
            new SetAttributesRequest(
                u16(r), flags(FileAttribute.class, r), flags(FileAttribute.class, r), wide(r)),
        () ->
            new ListDirectoryRequest(
                u16(r), flags(ItemType.class, r), flags(ListFlag.class, r), wide(r)),
        () ->
            new CreateFileRequest(
                u16(r),
                new Code<>(ItemType.class, u16(r)),
                new Flags<>(ModulePart.class, u8(r)),
                r.nextBoolean(),
                wide(r),
                wide(r)),
        () -> new DeleteFileRequest(u16(r), r.nextBoolean(), wide(r)),
        () ->
            new CopyFileRequest(
                u16(r),
                anyOf(r, MessageType.COPY_FILE, MessageType.MOVE_FILE),
                flags(CopyFlag.class, r),
                wide(r),
                wide(r)),
        () -> new FilePropertiesRequest(u16(r), flags(FileProperty.class, r), wide(r)),
        () ->
            new FileNameRequest(
                u16(r), anyOf(r, MessageType.FULL_NAME, MessageType.KRC_NAME), wide(r)));
  }

  private static Request c3ContentRequest(Random r) {
    return oneOf(
        r,
        () -> new BeginWriteRequest(u16(r), u32(r)),
        () -> new WriteDataRequest(u16(r), u32(r), bytes(r)),
        () -> new EndWriteRequest(u16(r), flags(CopyFlag.class, r), wide(r)),
        () -> new BeginReadRequest(u16(r), flags(CopyFlag.class, r), wide(r)),
        () -> new ReadDataRequest(u16(r), u32(r), u32(r)),
        () -> new ContentRequest(u16(r), content(r), operation(r, 0, 3, 5, 255)),
        () -> new ContentRequest(u16(r), MessageType.READ_CONTENT, Code.of(ContentOperation.END)));
  }

  static Response c3Response(Random r) {
    return oneOf(
        r, () -> c3VariableResponse(r), () -> c3FileResponse(r), () -> c3FailedResponse(r));
  }

  private static Response c3VariableResponse(Random r) {
    return oneOf(
        r,
        () -> new ValueResponse(u16(r), MessageType.READ, text(r), tail(r)),
        () -> new ValueResponse(u16(r), MessageType.WRITE, text(r), tail(r)),
        () -> new EmptyResponse(u16(r)),
        () ->
            new TextResponse(
                u16(r),
                anyOf(
                    r,
                    MessageType.READ_UTF16,
                    MessageType.WRITE_UTF16,
                    MessageType.FULL_NAME,
                    MessageType.KRC_NAME),
                wide(r),
                tail(r)),
        () ->
            new MultipleResponse(
                u16(r),
                anyOf(r, MessageType.READ_MULTIPLE, MessageType.WRITE_MULTIPLE),
                list(r, 0, 20, () -> new AccessResult(code(ErrorCode.class, r), wide(r))),
                tail(r)),
        () -> new ProgramResponse(u16(r), MessageType.PROGRAM_CONTROL, u8(r), tail(r)),
        () -> new ProgramResponse(u16(r), MessageType.MOTION, u8(r), tail(r)),
        () -> new ProgramResponse(u16(r), MessageType.PENDANT_KEY, u8(r), tail(r)),
        () -> new InformationResponse(u16(r), information(r), tail(r)),
        () ->
            new FeaturesResponse(
                u16(r), new Features(new HashSet<>(list(r, 0, 255, () -> u8(r)))), tail(r)),
        () ->
            new BenchmarkResponse(
                u16(r), r.nextBoolean(), u8(r), u32(r), u32(r), u32(r), u32(r), tail(r)));
  }

  private static Response c3FileResponse(Random r) {
    return oneOf(
        r,
        () ->
            new ListDirectoryResponse(
                u16(r), list(r, 0, 20, () -> wide(r)), list(r, 0, 20, () -> wide(r)), tail(r)),
        () -> new FilePropertiesResponse(u16(r), properties(r), tail(r)),
        () ->
            new ContentSizeResponse(
                u16(r),
                content(r),
                anyOf(r, ContentOperation.BEGIN, ContentOperation.SIZE),
                u32(r),
                tail(r)),
        () -> new WriteDataResponse(u16(r), u32(r), u32(r), tail(r)),
        () -> new ReadDataResponse(u16(r), u32(r), bytes(r), tail(r)),
        () -> new ContentResponse(u16(r), content(r), operation(r, 0, 4, 5, 255), tail(r)),
        () ->
            new PlainResponse(
                u16(r),
                anyOf(
                    r,
                    MessageType.SET_ATTRIBUTES,
                    MessageType.CREATE_FILE,
                    MessageType.DELETE_FILE,
                    MessageType.COPY_FILE,
                    MessageType.MOVE_FILE,
                    MessageType.CONFIRM_ALL),
                tail(r)));
  }

  private static Response c3FailedResponse(Random r) {
    MessageType[] types =
        Arrays.stream(MessageType.values())
            .filter(type -> !type.isKnownTo(ServerType.KUKAVARPROXY))
            .toArray(MessageType[]::new);
    Tail failed = new Tail(u16(r), 0);
    return oneOf(
        r,
        () -> new ContentResponse(u16(r), content(r), operation(r, 1, 2, 3, 4), failed),
        () -> new PlainResponse(u16(r), anyOf(r, types), failed));
  }

  private static Code<ProgramCommand> plainCommand(Random r) {
    Code<ProgramCommand> command = code(ProgramCommand.class, r);
    return ProgramLayouts.selects(command) ? plainCommand(r) : command;
  }

  private static Code<Interpreter> interpreter(Random r) {
    return new Code<>(Interpreter.class, Samples.between(r, -32768, 32767));
  }

  private static MessageType content(Random r) {
    return anyOf(r, MessageType.WRITE_CONTENT, MessageType.READ_CONTENT);
  }

  private static Code<ContentOperation> operation(Random r, Integer... numbers) {
    return new Code<>(ContentOperation.class, anyOf(r, numbers));
  }

  private static ServerInformation information(Random r) {
    SystemTime time =
        new SystemTime(u16(r), u16(r), u16(r), u16(r), u16(r), u16(r), u16(r), u16(r));
    return new ServerInformation(u8(r), u8(r), code(BuildType.class, r), time, wide(r));
  }

  private static FileProperties properties(Random r) {
    return new FileProperties(
        new Code<>(ItemType.class, i32(r)),
        Samples.between(r, 0, Long.MAX_VALUE),
        flags(FileAttribute.class, r),
        time(r),
        time(r),
        time(r),
        new Code<>(EditMode.class, i32(r)),
        wide(r));
  }

  private static ItemTime time(Random r) {
    return ItemTime.ofTicks(Samples.between(r, Long.MIN_VALUE, Long.MAX_VALUE), i32(r));
  }

  private static List<Assignment> assignments(Random r) {
    return list(r, 0, 20, () -> new Assignment(wide(r), wide(r)));
  }

  private static <E extends Enum<E> & WireCode> Code<E> code(Class<E> type, Random r) {
    return new Code<>(type, u8(r));
  }

  private static <E extends Enum<E> & WireCode> Flags<E> flags(Class<E> type, Random r) {
    return new Flags<>(type, i32(r));
  }

  private static Bytes bytes(Random r) {
    return Bytes.of(Samples.bytes(r, 600));
  }

  private static String wide(Random r) {
    return Samples.text(r, 60, Character.MAX_VALUE);
  }

  private static int u8(Random r) {
    return Samples.between(r, 0, 255);
  }

  private static int i32(Random r) {
    return Samples.between(r, Integer.MIN_VALUE, Integer.MAX_VALUE);
  }

  private static long u32(Random r) {
    return Samples.between(r, 0, 0xFFFF_FFFFL);
  }

  private static int u16(Random r) {
    return Samples.between(r, 0, 65535);
  }

  private static String text(Random r) {
    return Samples.text(r, 600, '\u00FF');
  }

  private static List<Integer> words(Random r) {
    return list(r, 0, 300, () -> u16(r));
  }

  private static Tail tail(Random r) {
    return new Tail(u16(r), u8(r));
  }
}
