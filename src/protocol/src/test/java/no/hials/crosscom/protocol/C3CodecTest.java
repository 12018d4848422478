package no.hials.crosscom.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Stream;
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
import no.hials.crosscom.protocol.variable.VariableRequest.ReadMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadUtf16Request;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteUtf16Request;
import no.hials.crosscom.protocol.variable.VariableResponse.BenchmarkResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.MultipleResponse;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The messages that only C3 Bridge has; {@link CodecTest} is about those of KUKAVARPROXY. */
final class C3CodecTest {
  private static final Tail REFUSED = new Tail(2, 0);

  private static final ItemTime MODIFIED = new ItemTime(Instant.parse("2022-03-24T00:00:00Z"), -60);

  /** Requests and their bytes. */
  static Stream<Arguments> goldenRequests() {
    return Stream.of(
        arguments(
            new ReadUtf16Request(512, "$ACT_BASE"),
            // read $ACT_BASE, id 512 (docs/reference/c3-messages.md#examples)
            """
            02 00  00 15  04
            00 09  24 00 41 00 43 00 54 00 5F 00 42 00 41 00 53 00 45 00
            """),
        arguments(
            new WriteUtf16Request(256, "$OV_PRO", "5"),
            // write $OV_PRO = 5, id 256 (docs/reference/c3-messages.md#examples)
            """
            01 00  00 15  05
            00 07  24 00 4F 00 56 00 5F 00 50 00 52 00 4F 00
            00 01  35 00
            """),
        arguments(
            new ReadMultipleRequest(1024, List.of("PING", "@PROXY_PORT")),
            // read PING, @PROXY_PORT, id 1024 (docs/reference/c3-messages.md#examples)
            """
            04 00  00 24  06
            02                                # 2 names
            00 04  50 00 49 00 4E 00 47 00
            00 0B  40 00 50 00 52 00 4F 00 58 00 59 00 5F 00 50 00 4F 00 52 00 54 00
            """),
        arguments(
            new ProgramControlRequest(
                652, Code.of(ProgramCommand.RESET), Code.of(Interpreter.SUBMIT)),
            // reset the submit interpreter, id 652 (docs/reference/c3-messages.md#examples)
            "02 8C  00 04  0A  01  00 00"),
        arguments(
            new WriteMultipleRequest(
                0x0400, List.of(new Assignment("$OV_PRO", "37"), new Assignment("$OV_JOG", "100"))),
            // c3-vectors.tsv: specification sample, 3.5.8
            """
            04 00  00 30  07
            02                                # 2 assignments
            00 07  24 00 4F 00 56 00 5F 00 50 00 52 00 4F 00
            00 02  33 00 37 00
            00 07  24 00 4F 00 56 00 5F 00 4A 00 4F 00 47 00
            00 03  31 00 30 00 30 00
            """),
        arguments(
            new ProgramControlRequest(
                0x0156, Code.of(ProgramCommand.START), new Code<>(Interpreter.class, -1)),
            // c3-vectors.tsv: interpreter -1 invalid
            "01 56  00 04  0A  02  FF FF"),
        arguments(
            new ProgramControlRequest(
                0x015A, new Code<>(ProgramCommand.class, 7), Code.of(Interpreter.ROBOT)),
            // c3-vectors.tsv: command 7 (disable start) not implemented
            "01 5A  00 04  0A  07  00 01"),
        arguments(
            new ProgramSelectRequest(
                0x0145,
                Code.of(ProgramCommand.SELECT),
                Code.of(Interpreter.ROBOT),
                "/R1/MAIN",
                "",
                true),
            // c3-vectors.tsv: select /R1/MAIN, no parameters, force
            """
            01 45  00 19  0A
            05  00 01                         # select
            00 08  2F 00 52 00 31 00 2F 00 4D 00 41 00 49 00 4E 00
            00 00                             # no parameters
            01                                # force
            """),
        arguments(
            new ProgramSelectRequest(
                1,
                Code.of(ProgramCommand.RUN),
                Code.of(Interpreter.SUBMIT),
                "P",
                "\u20AC,2",
                false),
            // laid out by hand from docs/reference/c3-messages.md#program-control-10
            """
            00 01  00 11  0A
            06  00 00                         # run
            00 01  50 00
            00 03  AC 20  2C 00  32 00        # the euro sign, a comma, 2
            00
            """),
        arguments(
            new MotionRequest(0x0167, Code.of(MotionType.PTP), "garbage"),
            // c3-vectors.tsv: bad position text
            "01 67  00 12  0B  01  00 07  67 00 61 00 72 00 62 00 61 00 67 00 65 00"),
        arguments(
            new PendantKeyRequest(0x0170, Code.of(PendantKey.JOG), 3, 2, true, false),
            // c3-vectors.tsv: key move axis 3 key 2 plus
            "01 70  00 0C  0C  03  00 00 00 03  00 00 00 02  01  00"),
        arguments(
            new PendantKeyRequest(1, Code.of(PendantKey.MOUSE), -2, 0x12345678, false, true),
            // laid out by hand from docs/reference/c3-messages.md#pendant-keys-12
            "00 01  00 0C  0C  04  FF FF FF FE  12 34 56 78  00  01"),
        arguments(
            new ServerRequest(0, MessageType.INFORMATION),
            // c3-vectors.tsv: specification sample, 3.8.1
            "00 00  00 01  0D"),
        arguments(
            new ServerRequest(0x01E6, MessageType.FEATURES),
            // c3-vectors.tsv: split, first part holds only the header of length 1 message
            "01 E6  00 01  0E"),
        arguments(
            new ServerRequest(0x017E, MessageType.CONFIRM_ALL),
            // c3-vectors.tsv: confirm all
            "01 7E  00 01  3F"),
        arguments(
            new BenchmarkReadRequest(2, 0xFEDCBA98L, List.of("A", "B1")),
            // laid out by hand from docs/reference/c3-messages.md#benchmark-17
            "00 02  00 11  11  00  02  FE DC BA 98  00 01 41 00  00 02 42 00 31 00"),
        arguments(
            new BenchmarkWriteRequest(2, 3, List.of(new Assignment("A", "7"))),
            // laid out by hand from docs/reference/c3-messages.md#benchmark-17
            "00 02  00 0F  11  01  01  00 00 00 03  00 01 41 00  00 01 37 00"),
        arguments(
            new SetAttributesRequest(
                3,
                Flags.of(FileAttribute.SIGNED, FileAttribute.HIDDEN),
                Flags.of(FileAttribute.READ_ONLY),
                "F"),
            // laid out by hand from docs/reference/c3-messages.md#files-20-to-28
            "00 03  00 0D  14  10 00 00 02  00 00 00 01  00 01 46 00"),
        arguments(
            new ListDirectoryRequest(
                0x0181, Flags.none(ItemType.class), Flags.none(ListFlag.class), "KRC:\\R1"),
            // c3-vectors.tsv: list KRC:\R1, all types, no flags
            """
            01 81  00 19  15
            00 00 00 00  00 00 00 00
            00 07  4B 00 52 00 43 00 3A 00 5C 00 52 00 31 00
            """),
        arguments(
            new ListDirectoryRequest(
                4,
                Flags.of(ItemType.TEXT, ItemType.MODULE),
                Flags.of(ListFlag.RECURSIVE, ListFlag.LONG),
                ""),
            // laid out by hand from docs/reference/c3-messages.md#files-20-to-28
            "00 04  00 0B  15  00 00 00 30  00 00 00 05  00 00"),
        arguments(
            new CreateFileRequest(
                5,
                Code.of(ItemType.MODULE),
                Flags.of(ModulePart.SRC, ModulePart.DAT),
                false,
                "job",
                ""),
            // c3-vectors.tsv: create module SRCDAT, with a shorter name and another id
            "00 05  00 0F  16  00 20  06  00  00 03  6A 00 6F 00 62 00  00 00"),
        arguments(
            new CreateFileRequest(
                5,
                Code.of(ItemType.PROTECTED_CONTAINER),
                Flags.none(ModulePart.class),
                true,
                "",
                "T"),
            // laid out by hand from docs/reference/c3-messages.md#files-20-to-28
            "00 05  00 0B  16  01 00  00  01  00 00  00 01 54 00"),
        arguments(
            new DeleteFileRequest(6, true, "F"),
            // laid out by hand from docs/reference/c3-messages.md#files-20-to-28
            "00 06  00 06  17  01  00 01 46 00"),
        arguments(
            new CopyFileRequest(
                7,
                MessageType.COPY_FILE,
                Flags.of(CopyFlag.OVERWRITE, CopyFlag.OVERWRITE_READ_ONLY),
                "A",
                "B"),
            // laid out by hand from docs/reference/c3-messages.md#files-20-to-28
            "00 07  00 0D  18  00 00 10 40  00 01 41 00  00 01 42 00"),
        arguments(
            new CopyFileRequest(7, MessageType.MOVE_FILE, Flags.none(CopyFlag.class), "A", "B"),
            // laid out by hand from docs/reference/c3-messages.md#files-20-to-28
            "00 07  00 0D  19  00 00 00 00  00 01 41 00  00 01 42 00"),
        arguments(
            new FilePropertiesRequest(8, Flags.all(FileProperty.class), "F"),
            // laid out by hand from docs/reference/c3-messages.md#files-20-to-28
            "00 08  00 09  1A  00 00 00 FF  00 01 46 00"),
        arguments(
            new FileNameRequest(9, MessageType.FULL_NAME, "/R1"),
            // laid out by hand from docs/reference/c3-messages.md#files-20-to-28
            "00 09  00 09  1B  00 03 2F 00 52 00 31 00"),
        arguments(
            new FileNameRequest(9, MessageType.KRC_NAME, "K"),
            // laid out by hand from docs/reference/c3-messages.md#files-20-to-28
            "00 09  00 05  1C  00 01 4B 00"),
        arguments(
            new BeginWriteRequest(0x01AF, 1024),
            // c3-vectors.tsv: begin 1024 bytes
            "01 AF  00 06  1D  01  00 00 04 00"),
        arguments(
            new WriteDataRequest(
                0x01B2, 5000, Bytes.of(Hex.bytes("78 78 78 78 78 78 78 78 78 78"))),
            // c3-vectors.tsv: data offset past the end
            """
            01 B2  00 14  1D  02  00 00 13 88
            00 00 00 0A  78 78 78 78 78 78 78 78 78 78
            """),
        arguments(
            new ContentRequest(0x01B4, MessageType.WRITE_CONTENT, Code.of(ContentOperation.SIZE)),
            // c3-vectors.tsv: get size
            "01 B4  00 02  1D  03"),
        arguments(
            new EndWriteRequest(10, Flags.of(CopyFlag.UPDATE), "F"),
            // laid out by hand from docs/reference/c3-messages.md#file-content-29-and-30
            "00 0A  00 0A  1D  04  00 00 00 30  00 01 46 00"),
        arguments(
            new ContentRequest(
                0x01BA, MessageType.WRITE_CONTENT, new Code<>(ContentOperation.class, 5)),
            // c3-vectors.tsv: operation 5 (checksum) not implemented
            "01 BA  00 02  1D  05"),
        arguments(
            new BeginReadRequest(11, Flags.of(CopyFlag.FORCE_BINARY), "F"),
            // laid out by hand from docs/reference/c3-messages.md#file-content-29-and-30
            "00 0B  00 0A  1E  01  00 00 02 00  00 01 46 00"),
        arguments(
            new ReadDataRequest(0x01C1, 1000, 100),
            // c3-vectors.tsv: data offset 1000 size 100
            "01 C1  00 0A  1E  02  00 00 03 E8  00 00 00 64"),
        arguments(
            new ReadDataRequest(12, 0x80000000L, ReadDataRequest.AS_MUCH_AS_FITS),
            // laid out by hand from docs/reference/c3-messages.md#file-content-29-and-30
            "00 0C  00 0A  1E  02  80 00 00 00  FF FF FF FF"),
        arguments(
            new ContentRequest(0x01C4, MessageType.READ_CONTENT, Code.of(ContentOperation.END)),
            // c3-vectors.tsv: end
            "01 C4  00 02  1E  04"));
  }

  /** Answers and their bytes. */
  static Stream<Arguments> goldenResponses() {
    return Stream.of(
        arguments(
            new TextResponse(512, MessageType.READ_UTF16, "1", Tail.SUCCESS),
            // answer 1 (docs/reference/c3-messages.md#examples)
            "02 00  00 08  04  00 01 31 00  00 01 01"),
        arguments(
            new TextResponse(256, MessageType.WRITE_UTF16, "5", Tail.SUCCESS),
            // answer to the write (docs/reference/c3-messages.md#examples)
            "01 00  00 08  05  00 01 35 00  00 01 01"),
        arguments(
            new MultipleResponse(
                1024,
                MessageType.READ_MULTIPLE,
                List.of(
                    new AccessResult(Code.of(ErrorCode.SUCCESS), "PONG"),
                    new AccessResult(Code.of(ErrorCode.SUCCESS), "7000")),
                Tail.SUCCESS),
            // answer PONG, 7000 (docs/reference/c3-messages.md#examples)
            """
            04 00  00 1B  06
            02                                # 2 results
            01  00 04  50 00 4F 00 4E 00 47 00
            01  00 04  37 00 30 00 30 00 30 00
            00 01  01
            """),
        arguments(
            new ProgramResponse(
                652, MessageType.PROGRAM_CONTROL, ProgramCommand.RESET.code(), Tail.SUCCESS),
            // answer to the reset (docs/reference/c3-messages.md#examples)
            "02 8C  00 05  0A  01  00 01 01"),
        arguments(
            new MultipleResponse(
                0x0140,
                MessageType.WRITE_MULTIPLE,
                List.of(
                    new AccessResult(Code.of(ErrorCode.SUCCESS), "8"),
                    new AccessResult(Code.of(ErrorCode.GENERAL), "1"),
                    new AccessResult(Code.of(ErrorCode.ACCESS), "#EX")),
                Tail.FAILURE_ZERO),
            // c3-vectors.tsv: write known, unknown, read-only
            """
            01 40  00 18  07
            03                                # 3 results
            01  00 01  38 00                  # written
            00  00 01  31 00                  # an unknown variable
            02  00 03  23 00 45 00 58 00      # access denied
            00 00  00
            """),
        arguments(
            new MultipleResponse(0x01D2, MessageType.READ_MULTIPLE, List.of(), new Tail(10, 0)),
            // c3-vectors.tsv: read BIG66000 multiple
            "01 D2  00 05  06  00  00 0A 00"),
        arguments(
            new ProgramResponse(0x015A, MessageType.PROGRAM_CONTROL, 7, new Tail(7, 0)),
            // c3-vectors.tsv: command 7 (disable start) not implemented
            "01 5A  00 05  0A  07  00 07 00"),
        arguments(
            new ProgramResponse(
                0x0163, MessageType.MOTION, MotionType.LIN_REL.code(), Tail.SUCCESS),
            // c3-vectors.tsv: LIN_REL
            "01 63  00 05  0B  04  00 01 01"),
        arguments(
            new ProgramResponse(
                0x0170, MessageType.PENDANT_KEY, PendantKey.JOG.code(), Tail.SUCCESS),
            // c3-vectors.tsv: key move axis 3 key 2 plus
            "01 70  00 05  0C  03  00 01 01"),
        arguments(
            new InformationResponse(
                0,
                new ServerInformation(
                    1,
                    4,
                    Code.of(BuildType.OPEN_SOURCE),
                    new SystemTime(2026, 11, 6, 21, 6, 25, 55, 468),
                    "VM"),
                Tail.SUCCESS),
            // c3-vectors.tsv: specification sample, 3.8.1
            """
            00 00  00 1D  0D
            01  04  00                        # 1.4, open source
            07 EA  00 0B  00 06  00 15        # 2026-11, Saturday, 21
            00 06  00 19  00 37  01 D4        # 06:25:55.468
            00 02  56 00 4D 00                # VM
            00 01  01
            """),
        arguments(
            new FeaturesResponse(
                0x01E6,
                new Features(
                    Set.of(
                        0, 1, 4, 5, 6, 7, 10, 11, 12, 13, 14, 17, 20, 21, 22, 23, 24, 25, 26, 27,
                        28, 29, 30, 63)),
                Tail.SUCCESS),
            // c3-vectors.tsv: split, first part holds only the header of length 1 message
            """
            01 E6  00 24  0E
            00 00 00 00 00 00 00 00  00 00 00 00 00 00 00 00
            00 00 00 00 00 00 00 00  80 00 00 00 7F F2 7C F3
            00 01  01
            """),
        arguments(
            new BenchmarkResponse(0x017D, false, 2, 1, 0, 0, 0, new Tail(9, 0)),
            // c3-vectors.tsv: benchmark, missing names
            """
            01 7D  00 16  11  00  02  00 00 00 01
            00 00 00 00  00 00 00 00  00 00 00 00
            00 09  00
            """),
        arguments(
            new BenchmarkResponse(13, true, 10, 1000, 0xFFFFFFF0L, 16, 32, Tail.SUCCESS),
            // laid out by hand from docs/reference/c3-messages.md#benchmark-17
            """
            00 0D  00 16  11  01  0A  00 00 03 E8
            FF FF FF F0  00 00 00 10  00 00 00 20
            00 01  01
            """),
        arguments(
            new PlainResponse(0x018A, MessageType.SET_ATTRIBUTES, Tail.SUCCESS),
            // c3-vectors.tsv: clear read-only
            "01 8A  00 04  14  00 01 01"),
        arguments(
            new ListDirectoryResponse(14, List.of("a", "bc"), List.of("32,32,21"), Tail.SUCCESS),
            // laid out by hand from docs/reference/c3-messages.md#files-20-to-28
            """
            00 0E  00 24  15
            00 02  00 01 61 00  00 02 62 00 63 00
            00 01  00 08 33 00 32 00 2C 00 33 00 32 00 2C 00 32 00 31 00
            00 01  01
            """),
        arguments(
            new ListDirectoryResponse(0x0187, List.of(), List.of(), new Tail(10, 0)),
            // c3-vectors.tsv: list 1500 files: answer too long
            "01 87  00 08  15  00 00  00 00  00 0A 00"),
        arguments(
            new PlainResponse(0x018D, MessageType.CREATE_FILE, Tail.SUCCESS),
            // c3-vectors.tsv: create module SRCDAT
            "01 8D  00 04  16  00 01 01"),
        arguments(
            new PlainResponse(0x019F, MessageType.DELETE_FILE, REFUSED),
            // c3-vectors.tsv: delete locked.txt without always
            "01 9F  00 04  17  00 02 00"),
        arguments(
            new PlainResponse(0x0196, MessageType.COPY_FILE, Tail.SUCCESS),
            // c3-vectors.tsv: copy notes.txt to Sub
            "01 96  00 04  18  00 01 01"),
        arguments(
            new PlainResponse(0x019C, MessageType.MOVE_FILE, Tail.FAILURE_ZERO),
            // c3-vectors.tsv: move missing source
            "01 9C  00 04  19  00 00 00"),
        arguments(
            new FilePropertiesResponse(
                0x01A2,
                new FileProperties(
                    Code.of(ItemType.TEXT),
                    8,
                    Flags.of(FileAttribute.READ_ONLY, FileAttribute.ARCHIVE),
                    MODIFIED,
                    MODIFIED,
                    MODIFIED,
                    Code.of(EditMode.READ_ONLY),
                    "locked.txt"),
                Tail.SUCCESS),
            // c3-vectors.tsv: properties locked.txt mask 255 (edit mode 3)
            """
            01 A2  00 52  1A
            00 00 00 10                              # a text
            00 00 00 08  00 00 00 00                 # of 8 bytes, low half first
            00 00 00 21                              # read only, archive
            1A DB C0 00  01 D8 3F 12  FF FF FF C4    # created, UTC+1
            1A DB C0 00  01 D8 3F 12  FF FF FF C4    # read
            1A DB C0 00  01 D8 3F 12  FF FF FF C4    # changed
            00 00 00 03                              # read only
            00 0A  6C 00 6F 00 63 00 6B 00 65 00 64 00 2E 00 74 00 78 00 74 00
            00 01  01
            """),
        arguments(
            new FilePropertiesResponse(0x01A6, FileProperties.NONE, Tail.FAILURE_ZERO),
            // c3-vectors.tsv: properties missing file
            "01 A6  00 3E  1A " + "00 ".repeat(58) + "00 00 00"),
        arguments(
            new TextResponse(0x01A9, MessageType.FULL_NAME, "", Tail.FAILURE_ZERO),
            // c3-vectors.tsv: full name of missing file
            "01 A9  00 06  1B  00 00  00 00 00"),
        arguments(
            new TextResponse(15, MessageType.KRC_NAME, "/R1", Tail.SUCCESS),
            // laid out by hand from docs/reference/c3-messages.md#files-20-to-28
            "00 0F  00 0C  1C  00 03 2F 00 52 00 31 00  00 01 01"),
        arguments(
            new ContentSizeResponse(
                0x01AF, MessageType.WRITE_CONTENT, ContentOperation.BEGIN, 1024, Tail.SUCCESS),
            // c3-vectors.tsv: begin 1024 bytes
            "01 AF  00 09  1D  01  00 00 04 00  00 01 01"),
        arguments(
            new WriteDataResponse(0x01B2, 5000, 0, Tail.SUCCESS),
            // c3-vectors.tsv: data offset past the end: size 0
            "01 B2  00 0D  1D  02  00 00 13 88  00 00 00 00  00 01 01"),
        arguments(
            new ContentSizeResponse(
                0x01BE, MessageType.WRITE_CONTENT, ContentOperation.BEGIN, 4, new Tail(9, 0)),
            // c3-vectors.tsv: begin without total
            "01 BE  00 09  1D  01  00 00 00 04  00 09 00"),
        arguments(
            new ContentResponse(
                0x01B5, MessageType.WRITE_CONTENT, Code.of(ContentOperation.END), Tail.SUCCESS),
            // c3-vectors.tsv: end: write content to new.bin
            "01 B5  00 05  1D  04  00 01 01"),
        arguments(
            new PlainResponse(0x01BD, MessageType.WRITE_CONTENT, new Tail(9, 0)),
            // c3-vectors.tsv: data without fields
            "01 BD  00 04  1D  00 09 00"),
        arguments(
            new ContentSizeResponse(
                0x01C5, MessageType.READ_CONTENT, ContentOperation.BEGIN, 0, Tail.FAILURE_ZERO),
            // c3-vectors.tsv: begin missing file
            "01 C5  00 09  1E  01  00 00 00 00  00 00 00"),
        arguments(
            new ContentSizeResponse(
                16, MessageType.READ_CONTENT, ContentOperation.SIZE, 0xFFFFFFFFL, Tail.SUCCESS),
            // laid out by hand from docs/reference/c3-messages.md#file-content-29-and-30
            "00 10  00 09  1E  03  FF FF FF FF  00 01 01"),
        arguments(
            new ReadDataResponse(17, 1000, Bytes.of(Hex.bytes("E8 00 FF")), Tail.SUCCESS),
            // laid out by hand from docs/reference/c3-messages.md#file-content-29-and-30
            "00 11  00 10  1E  02  00 00 03 E8  00 00 00 03  E8 00 FF  00 01 01"),
        arguments(
            new ContentResponse(
                0x01C9,
                MessageType.READ_CONTENT,
                new Code<>(ContentOperation.class, 9),
                new Tail(7, 0)),
            // c3-vectors.tsv: operation 9
            "01 C9  00 05  1E  09  00 07 00"),
        arguments(
            new PlainResponse(0x017E, MessageType.CONFIRM_ALL, Tail.SUCCESS),
            // c3-vectors.tsv: confirm all
            "01 7E  00 04  3F  00 01 01"));
  }

  private static Request decodeRequest(byte[] frame) throws MalformedFrameException {
    return Codec.decodeRequest(frame, ServerType.C3_BRIDGE, Strictness.STRICT);
  }

  private static Request decodeLeniently(byte[] frame) throws MalformedFrameException {
    return Codec.decodeRequest(frame, ServerType.C3_BRIDGE, Strictness.LENIENT);
  }

  private static Response decodeResponse(byte[] frame) throws MalformedFrameException {
    return Codec.decodeResponse(frame, ServerType.C3_BRIDGE);
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenRequests")
  void aRequestHasTheBytesOfTheReference(Request request, String golden) {
    assertThat(Codec.encode(request)).isEqualTo(Hex.bytes(golden));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenRequests")
  void theBytesOfTheReferenceAreTheRequest(Request request, String golden) throws Exception {
    assertThat(decodeRequest(Hex.bytes(golden))).isEqualTo(request);
    assertThat(decodeLeniently(Hex.bytes(golden))).isEqualTo(request);
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenResponses")
  void anAnswerHasTheBytesOfTheReference(Response response, String golden) {
    assertThat(Codec.encode(response)).isEqualTo(Hex.bytes(golden));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenResponses")
  void theBytesOfTheReferenceAreTheAnswer(Response response, String golden) throws Exception {
    assertThat(decodeResponse(Hex.bytes(golden))).isEqualTo(response);
  }

  @Test
  void everyTypeHasAGoldenRequestAndAGoldenAnswer() {
    Set<MessageType> requests = types(goldenRequests());
    Set<MessageType> responses = types(goldenResponses());

    for (MessageType type : MessageType.values()) {
      boolean legacy = type.isKnownTo(ServerType.KUKAVARPROXY);
      assertThat(requests.contains(type)).as("request %s", type).isNotEqualTo(legacy);
      assertThat(responses.contains(type)).as("answer %s", type).isNotEqualTo(legacy);
    }
  }

  private static Set<MessageType> types(Stream<Arguments> golden) {
    Set<MessageType> types = new HashSet<>();
    golden
        .map(arguments -> arguments.get()[0])
        .forEach(m -> types.add(m instanceof Request r ? r.type() : ((TypedResponse) m).type()));
    return types;
  }

  // what is cut or has something left over

  /** Counts a frame again. */
  private static byte[] counted(byte[] frame) {
    int length = frame.length - Codec.HEADER_LENGTH;
    frame[2] = (byte) (length >> 8);
    frame[3] = (byte) length;
    return frame;
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenRequests")
  void aRequestCutAnywhereIsMalformed(Request request, String golden) {
    byte[] frame = Hex.bytes(golden);
    for (int length = Codec.HEADER_LENGTH; length < frame.length; length++) {
      byte[] cut = counted(Arrays.copyOf(frame, length));
      assertThatExceptionOfType(MalformedFrameException.class)
          .as("%s cut to %s", request, length)
          .isThrownBy(() -> decodeRequest(cut));
    }
  }

  /** Makes an answer of the first fields of another and a tail. */
  private static byte[] answer(byte[] frame, int length, Tail tail) {
    byte[] changed = Arrays.copyOf(frame, length + Tail.LENGTH);
    changed[length] = (byte) (tail.code() >> 8);
    changed[length + 1] = (byte) tail.code();
    changed[length + 2] = (byte) tail.flag();
    return counted(changed);
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenResponses")
  void aSuccessWithFieldsCutAnywhereIsMalformed(Response response, String golden) {
    byte[] frame = Hex.bytes(golden);
    for (int length = 5; length < frame.length - Tail.LENGTH; length++) {
      byte[] cut = answer(frame, length, Tail.SUCCESS);
      assertThatExceptionOfType(MalformedFrameException.class)
          .as("%s cut to %s", response, length)
          .isThrownBy(() -> decodeResponse(cut));
    }
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenResponses")
  void aFailureWithoutFieldsIsAnAnswerWithItsCode(TypedResponse response, String golden)
      throws Exception {
    byte[] cut = answer(Hex.bytes(golden), 5, REFUSED);

    Response plain = decodeResponse(cut);

    assertThat(plain).isEqualTo(new PlainResponse(response.id(), response.type(), REFUSED));
    assertThat(Codec.encode(plain)).isEqualTo(cut);
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenResponses")
  void aFailureWithSomeOfItsFieldsIsMalformedUnlessOnlyAContentsOperationIsThere(
      TypedResponse response, String golden) {
    byte[] frame = Hex.bytes(golden);
    boolean content =
        response.type() == MessageType.WRITE_CONTENT || response.type() == MessageType.READ_CONTENT;
    for (int length = content ? 7 : 6; length < frame.length - Tail.LENGTH; length++) {
      byte[] cut = answer(frame, length, REFUSED);
      assertThatExceptionOfType(MalformedFrameException.class)
          .as("%s cut to %s", response, length)
          .isThrownBy(() -> decodeResponse(cut));
    }
  }

  @ParameterizedTest
  @EnumSource(
      value = MessageType.class,
      names = {"WRITE_CONTENT", "READ_CONTENT"})
  void aFailureThatHasOnlyAContentsOperationIsThatOperation(MessageType type) throws Exception {
    for (int operation : new int[] {0, 1, 2, 3, 4, 255}) {
      ContentResponse response =
          new ContentResponse(1, type, new Code<>(ContentOperation.class, operation), REFUSED);

      assertThat(decodeResponse(Codec.encode(response))).isEqualTo(response);
    }
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenRequests")
  void bytesAfterTheLastFieldOfARequestAreMalformedButIgnoredByALenientServer(
      Request request, String golden) throws Exception {
    byte[] frame = Hex.bytes(golden);
    for (int more : new int[] {1, 300}) {
      byte[] longer = counted(Arrays.copyOf(frame, frame.length + more));

      assertThatExceptionOfType(MalformedRequestException.class)
          .isThrownBy(() -> decodeRequest(longer))
          .withMessageStartingWith(more + " bytes are left after the last field, frame: ");
      assertThat(decodeLeniently(longer)).isEqualTo(request);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"00 00  00 04  00  00 00  41", "00 00  00 06  01  00 00  00 00  41"})
  void surplusIsIgnoredInTheOldFunctionsTooIfLenient(String golden) throws Exception {
    assertThat(Codec.encode(decodeLeniently(Hex.bytes(golden)))).hasSizeLessThan(10);
    assertThatExceptionOfType(MalformedRequestException.class)
        .isThrownBy(() -> decodeRequest(Hex.bytes(golden)));
  }

  /** All but the one failure that becomes another message when it has one byte more. */
  static Stream<Arguments> completeResponses() {
    return goldenResponses()
        .filter(
            arguments ->
                !(arguments.get()[0] instanceof PlainResponse plain
                    && plain.type() == MessageType.WRITE_CONTENT));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("completeResponses")
  void bytesBetweenLastFieldAndTailAreMalformed(TypedResponse response, String golden) {
    byte[] frame = Hex.bytes(golden);
    byte[] longer = answer(frame, frame.length - Tail.LENGTH + 1, response.tail());

    assertThatExceptionOfType(MalformedFrameException.class)
        .isThrownBy(() -> decodeResponse(longer))
        .withMessageStartingWith("1 bytes are left after the last field, frame: ");
  }

  static Stream<Arguments> brokenRequests() {
    return Stream.of(
        arguments("00 00  00 03  04  00 01", "name needs 2 bytes, 0 are left"),
        arguments("00 00  00 04  04  00 01 41", "name needs 2 bytes, 1 are left"),
        arguments("00 00  00 05  04  FF FF 41 00", "name needs 131070 bytes, 2 are left"),
        arguments("00 00  00 09  0A  05 00 01  00 00  00 00  02", "force must be 0 or 1, is 2"),
        arguments(
            "00 00  00 0C  0C  01  00 00 00 01  00 00 00 00  00  FF",
            "released must be 0 or 1, is 255"),
        arguments("00 00  00 07  11  02  00  00 00 00 01", "write must be 0 or 1, is 2"),
        arguments("00 00  00 04  17  03  00 00", "always must be 0 or 1, is 3"),
        arguments("00 00  00 02  0A  01", "interpreter needs 2 bytes, 0 are left"),
        arguments(
            "00 00  00 0B  1D  02  00 00 00 00  00 00 00 02  41", "data needs 2 bytes, 1 are left"),
        arguments(
            "00 00  00 0A  1D  02  00 00 00 00  FF FF FF FF",
            "data needs 4294967295 bytes, 0 are left"));
  }

  @ParameterizedTest(name = "{0}: {1}")
  @MethodSource("brokenRequests")
  void aBrokenRequestIsRefusedWithTheRuleItBreaks(String hex, String rule) {
    assertThatExceptionOfType(MalformedRequestException.class)
        .isThrownBy(() -> decodeRequest(Hex.bytes(hex)))
        .withMessage(rule + ", frame: " + hex.replaceAll(" +", " "));
  }

  static Stream<Arguments> brokenResponses() {
    return Stream.of(
        arguments("00 00  00 06  04  00 01  00 01 01", "text needs 2 bytes, 0 are left"),
        arguments("00 00  00 05  06  01  00 01 00", "code needs 1 bytes, 0 are left"),
        arguments("00 00  00 06  15  FF FF  00 01 01", "item length needs 2 bytes, 0 are left"),
        arguments("00 00  00 07  0E  00 00 00  00 01 01", "features needs 32 bytes, 3 are left"),
        arguments("00 00  00 05  14  00  00 01 01", "1 bytes are left after the last field"),
        arguments(
            "00 00  00 09  1D  04  00 00 00 00  00 01 01", "4 bytes are left after the last field"),
        arguments(
            "00 00  00 10  1A  00 00 00 00  00 00 00 00  80 00 00 00  00 01 01",
            "size must not be negative, is -9223372036854775808"));
  }

  @ParameterizedTest(name = "{0}: {1}")
  @MethodSource("brokenResponses")
  void aBrokenAnswerIsRefusedWithTheRuleItBreaks(String hex, String rule) {
    assertThatExceptionOfType(MalformedFrameException.class)
        .isThrownBy(() -> decodeResponse(Hex.bytes(hex)))
        .withMessage(rule + ", frame: " + hex.replaceAll(" +", " "));
  }

  // what a lenient server reads

  @Test
  void anyTruthValueButZeroIsTrueToALenientServer() throws Exception {
    byte[] frame = Hex.bytes("00 00  00 06  17  80  00 01 46 00");

    assertThat(decodeLeniently(frame)).isEqualTo(new DeleteFileRequest(0, true, "F"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "00", "00 01 42", "00 01 42 00", "00 01 42 00  00 01"})
  void aWriteOfSeveralVariablesThatEndsEarlyHasThoseThatAreWholeToALenientServer(String rest)
      throws Exception {
    byte[] whole = Codec.encode(new WriteMultipleRequest(1, 2, List.of(new Assignment("A", "1"))));
    byte[] more = Hex.bytes(rest);
    byte[] frame = Arrays.copyOf(whole, whole.length + more.length);
    System.arraycopy(more, 0, frame, whole.length, more.length);

    Request request = decodeLeniently(counted(frame));

    assertThat(request)
        .isEqualTo(new WriteMultipleRequest(1, 2, List.of(new Assignment("A", "1"))));
    assertThatExceptionOfType(MalformedRequestException.class)
        .isThrownBy(() -> decodeRequest(frame));
  }

  @Test
  void aWriteOfSeveralVariablesWithoutACountIsMalformedToALenientServerToo() {
    assertThatExceptionOfType(MalformedRequestException.class)
        .isThrownBy(() -> decodeLeniently(Hex.bytes("00 00  00 01  07")));
  }

  // which server knows what

  @ParameterizedTest
  @ValueSource(ints = {2, 3, 8, 9, 15, 16, 18, 19, 31, 62, 64, 127, 128, 255})
  void aFunctionThatC3BridgeHasNotIsSaidWithItsIdAndNumber(int function) {
    byte[] request = Hex.bytes("AB CD  00 01  00");
    request[4] = (byte) function;
    byte[] response = Hex.bytes("AB CD  00 04  00  00 01 01");
    response[4] = (byte) function;
    String message =
        "function must be 0 to 1, 4 to 7, 10 to 14, 17, 20 to 30, 63, is "
            + function
            + ", frame: AB CD 00 ";

    assertThatExceptionOfType(UnknownFunctionException.class)
        .isThrownBy(() -> decodeRequest(request))
        .withMessageStartingWith(message)
        .satisfies(e -> assertThat(e.id()).isEqualTo(0xABCD))
        .satisfies(e -> assertThat(e.function()).isEqualTo(function));
    assertThatExceptionOfType(UnknownFunctionException.class)
        .isThrownBy(() -> decodeResponse(response))
        .withMessageStartingWith(message);
  }

  @Test
  void aRequestThatIsMalformedSaysItsIdItsTypeAndItsFields() {
    assertThatExceptionOfType(MalformedRequestException.class)
        .isThrownBy(() -> decodeRequest(Hex.bytes("01 5C  00 02  0A  02")))
        .satisfies(e -> assertThat(e.id()).isEqualTo(0x015C))
        .satisfies(e -> assertThat(e.type()).isEqualTo(MessageType.PROGRAM_CONTROL))
        .satisfies(e -> assertThat(e.fields()).containsExactly(2));
  }

  @Test
  void typesSayWhichServersKnowThemAndSinceWhen() {
    assertThat(MessageType.values())
        .extracting(
            type ->
                type.code()
                    + " "
                    + Stream.of(ServerType.values()).filter(type::isKnownTo).toList()
                    + type.since().map(version -> " " + version).orElse(""))
        // docs/reference/c3-messages.md#server-versions
        .containsExactly(
            "0 [KUKAVARPROXY, C3_BRIDGE] 1.0",
            "1 [KUKAVARPROXY, C3_BRIDGE] 1.0",
            "2 [KUKAVARPROXY]",
            "3 [KUKAVARPROXY]",
            "4 [C3_BRIDGE] 1.0",
            "5 [C3_BRIDGE] 1.0",
            "6 [C3_BRIDGE] 1.2",
            "7 [C3_BRIDGE] 1.3",
            "10 [C3_BRIDGE] 1.0",
            "11 [C3_BRIDGE] 1.0",
            "12 [C3_BRIDGE] 1.0",
            "13 [C3_BRIDGE] 1.0",
            "14 [C3_BRIDGE] 1.0",
            "17 [C3_BRIDGE] 1.2",
            "20 [C3_BRIDGE] 1.1.2",
            "21 [C3_BRIDGE] 1.1.2",
            "22 [C3_BRIDGE] 1.1.2",
            "23 [C3_BRIDGE] 1.1.2",
            "24 [C3_BRIDGE] 1.1.2",
            "25 [C3_BRIDGE] 1.1.2",
            "26 [C3_BRIDGE] 1.1.2",
            "27 [C3_BRIDGE] 1.1.2",
            "28 [C3_BRIDGE] 1.1.2",
            "29 [C3_BRIDGE] 1.1.2",
            "30 [C3_BRIDGE] 1.1.2",
            "63 [C3_BRIDGE] 1.0");
  }

  @Test
  void typesAreFoundByTheirNumbersAndNoOthers() {
    for (MessageType type : MessageType.values()) {
      assertThat(MessageType.from(type.code())).contains(type);
    }
    assertThat(Stream.of(-1, 8, 62, 64, 255, 256).map(MessageType::from))
        .allMatch(Optional::isEmpty);
  }

  @Test
  void theServersTypesAreThoseThatItAnnouncesItself() throws Exception {
    // c3-vectors.tsv: a measured answer of type 14, of version 1.4
    Features features =
        ((FeaturesResponse)
                decodeResponse(
                    Hex.bytes(
                        "01 E6  00 24  0E "
                            + "00 ".repeat(24)
                            + "80 00 00 00 7F F2 7C F3  00 01 01")))
            .features();

    assertThat(MessageType.values())
        .filteredOn(features::has)
        .containsExactlyElementsOf(ServerType.C3_BRIDGE.types());
  }

  // the limits

  static Stream<Request> requestsAtTheLimits() {
    return Stream.of(
        new ReadUtf16Request(65535, "\uFFFF".repeat(32766)),
        new ReadUtf16Request(0, "\uD800a\uDC00\0"),
        new WriteUtf16Request(0, "", "v".repeat(32765)),
        new ReadMultipleRequest(0, List.of()),
        new ReadMultipleRequest(0, Collections.nCopies(255, "n".repeat(127))),
        new WriteMultipleRequest(0, Collections.nCopies(255, new Assignment("A", ""))),
        new ProgramSelectRequest(
            0,
            Code.of(ProgramCommand.SELECT),
            new Code<>(Interpreter.class, -32768),
            "n".repeat(32763),
            "",
            false),
        new ProgramControlRequest(
            0, new Code<>(ProgramCommand.class, 255), new Code<>(Interpreter.class, 32767)),
        new MotionRequest(0, new Code<>(MotionType.class, 255), "p".repeat(32765)),
        new PendantKeyRequest(
            0, new Code<>(PendantKey.class, 255), Integer.MIN_VALUE, Integer.MAX_VALUE, true, true),
        new BenchmarkReadRequest(0, 0xFFFFFFFFL, Collections.nCopies(255, "")),
        new BenchmarkWriteRequest(0, 0, Collections.nCopies(255, new Assignment("", ""))),
        new SetAttributesRequest(
            0,
            new Flags<>(FileAttribute.class, -1),
            new Flags<>(FileAttribute.class, Integer.MIN_VALUE),
            "n".repeat(32762)),
        new ListDirectoryRequest(
            0, new Flags<>(ItemType.class, -1), new Flags<>(ListFlag.class, -1), "n".repeat(32762)),
        new CreateFileRequest(
            0,
            new Code<>(ItemType.class, 65535),
            new Flags<>(ModulePart.class, 255),
            true,
            "n".repeat(32763),
            ""),
        new DeleteFileRequest(0, false, "n".repeat(32765)),
        new CopyFileRequest(
            0, MessageType.COPY_FILE, new Flags<>(CopyFlag.class, -1), "n".repeat(32763), ""),
        new FilePropertiesRequest(0, new Flags<>(FileProperty.class, -1), "n".repeat(32764)),
        new FileNameRequest(0, MessageType.KRC_NAME, "n".repeat(32766)),
        new BeginWriteRequest(0, 0xFFFFFFFFL),
        new WriteDataRequest(0, 0xFFFFFFFFL, Bytes.of(new byte[65525])),
        new WriteDataRequest(0, 0, Bytes.of(new byte[0])),
        new EndWriteRequest(0, new Flags<>(CopyFlag.class, -1), "n".repeat(32763)),
        new BeginReadRequest(0, new Flags<>(CopyFlag.class, -1), "n".repeat(32763)));
  }

  @ParameterizedTest
  @MethodSource("requestsAtTheLimits")
  void aRequestAtTheLimitsComesBackAsItWas(Request request) throws Exception {
    byte[] frame = Codec.encode(request);

    assertThat(Codec.frameLength(frame, 0)).isEqualTo(frame.length);
    assertThat(decodeRequest(frame)).isEqualTo(request);
  }

  static Stream<Response> responsesAtTheLimits() {
    ItemTime first = ItemTime.ofTicks(Long.MIN_VALUE, Integer.MIN_VALUE);
    ItemTime last = ItemTime.ofTicks(Long.MAX_VALUE, Integer.MAX_VALUE);
    return Stream.of(
        new TextResponse(65535, MessageType.READ_UTF16, "v".repeat(32764), Tail.SUCCESS),
        new MultipleResponse(
            0,
            MessageType.READ_MULTIPLE,
            Collections.nCopies(255, new AccessResult(new Code<>(ErrorCode.class, 255), "")),
            REFUSED),
        new ProgramResponse(0, MessageType.PROGRAM_CONTROL, 255, REFUSED),
        new InformationResponse(
            0,
            new ServerInformation(
                255,
                255,
                new Code<>(BuildType.class, 255),
                new SystemTime(65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535),
                "n".repeat(32755)),
            Tail.SUCCESS),
        new FeaturesResponse(0, new Features(Set.of(0, 7, 8, 255)), Tail.SUCCESS),
        new FeaturesResponse(0, new Features(Set.of()), Tail.SUCCESS),
        new ListDirectoryResponse(0, Collections.nCopies(32763, ""), List.of(), Tail.SUCCESS),
        new FilePropertiesResponse(
            0,
            new FileProperties(
                new Code<>(ItemType.class, Integer.MIN_VALUE),
                Long.MAX_VALUE,
                new Flags<>(FileAttribute.class, -1),
                first,
                last,
                ItemTime.NONE,
                Code.of(EditMode.UNKNOWN),
                "n".repeat(32736)),
            Tail.SUCCESS),
        new WriteDataResponse(0, 0xFFFFFFFFL, 0xFFFFFFFFL, Tail.SUCCESS),
        new ReadDataResponse(0, 0xFFFFFFFFL, Bytes.of(new byte[65522]), Tail.SUCCESS));
  }

  @ParameterizedTest
  @MethodSource("responsesAtTheLimits")
  void anAnswerAtTheLimitsComesBackAsItWas(Response response) throws Exception {
    byte[] frame = Codec.encode(response);

    assertThat(Codec.frameLength(frame, 0)).isEqualTo(frame.length);
    assertThat(decodeResponse(frame)).isEqualTo(response);
  }

  @Test
  void theLongestAnswersHave65539Bytes() {
    assertThat(
            Codec.encode(
                new ListDirectoryResponse(0, List.of("i".repeat(32762)), List.of(), Tail.SUCCESS)))
        .hasSize(Codec.MAX_FRAME_LENGTH - 1);
    assertThat(Codec.encode(new ReadDataResponse(0, 0, Bytes.of(new byte[65522]), Tail.SUCCESS)))
        .hasSize(Codec.MAX_FRAME_LENGTH);
  }

  static Stream<Arguments> outOfRange() {
    List<Arguments> rows = new ArrayList<>();
    String id = "id must be 0 to 65535, is 65536";
    int wrong = 65536;
    Flags<CopyFlag> copy = Flags.none(CopyFlag.class);
    Code<ProgramCommand> start = Code.of(ProgramCommand.START);
    Code<ProgramCommand> select = Code.of(ProgramCommand.SELECT);
    Code<Interpreter> robot = Code.of(Interpreter.ROBOT);
    Flags<FileAttribute> attributes = Flags.none(FileAttribute.class);
    rows.add(refused(() -> new ReadUtf16Request(wrong, ""), id));
    rows.add(refused(() -> new WriteUtf16Request(wrong, "", ""), id));
    rows.add(refused(() -> new ReadMultipleRequest(wrong, List.of()), id));
    rows.add(refused(() -> new WriteMultipleRequest(wrong, List.of()), id));
    rows.add(refused(() -> new ProgramControlRequest(wrong, start, robot), id));
    rows.add(refused(() -> new ProgramSelectRequest(wrong, select, robot, "", "", true), id));
    rows.add(refused(() -> new MotionRequest(wrong, Code.of(MotionType.PTP), ""), id));
    rows.add(
        refused(
            () -> new PendantKeyRequest(wrong, Code.of(PendantKey.STOP), 0, 0, true, true), id));
    rows.add(refused(() -> new ServerRequest(wrong, MessageType.FEATURES), id));
    rows.add(refused(() -> new BenchmarkReadRequest(wrong, 0, List.of()), id));
    rows.add(refused(() -> new BenchmarkWriteRequest(wrong, 0, List.of()), id));
    rows.add(refused(() -> new SetAttributesRequest(wrong, attributes, attributes, ""), id));
    rows.add(
        refused(
            () ->
                new ListDirectoryRequest(
                    wrong, Flags.none(ItemType.class), Flags.none(ListFlag.class), ""),
            id));
    rows.add(
        refused(
            () ->
                new CreateFileRequest(
                    wrong, Code.of(ItemType.TEXT), Flags.none(ModulePart.class), false, "", ""),
            id));
    rows.add(refused(() -> new DeleteFileRequest(wrong, false, ""), id));
    rows.add(refused(() -> new CopyFileRequest(wrong, MessageType.COPY_FILE, copy, "", ""), id));
    rows.add(refused(() -> new FileNameRequest(wrong, MessageType.KRC_NAME, ""), id));
    rows.add(
        refused(() -> new FilePropertiesRequest(wrong, Flags.all(FileProperty.class), ""), id));
    rows.add(refused(() -> new BeginWriteRequest(wrong, 0), id));
    rows.add(refused(() -> new WriteDataRequest(wrong, 0, Bytes.of(new byte[0])), id));
    rows.add(refused(() -> new EndWriteRequest(wrong, copy, ""), id));
    rows.add(refused(() -> new BeginReadRequest(wrong, copy, ""), id));
    rows.add(refused(() -> new ReadDataRequest(wrong, 0, 0), id));
    rows.add(refused(() -> content(wrong, MessageType.READ_CONTENT, 4), id));
    return rows.stream();
  }

  private static ContentRequest content(int id, MessageType type, int operation) {
    return new ContentRequest(id, type, new Code<>(ContentOperation.class, operation));
  }

  static Stream<Arguments> answersOutOfRange() {
    String id = "id must be 0 to 65535, is -1";
    Tail tail = Tail.SUCCESS;
    ServerInformation information =
        new ServerInformation(1, 4, Code.of(BuildType.INTERNAL), SystemTime.of(Instant.EPOCH), "");
    return Stream.of(
        refused(() -> new TextResponse(-1, MessageType.KRC_NAME, "", tail), id),
        refused(() -> new MultipleResponse(-1, MessageType.READ_MULTIPLE, List.of(), tail), id),
        refused(
            () ->
                new ProgramResponse(
                    -1, MessageType.PROGRAM_CONTROL, ProgramCommand.STOP.code(), tail),
            id),
        refused(() -> new ProgramResponse(-1, MessageType.MOTION, MotionType.LIN.code(), tail), id),
        refused(
            () -> new ProgramResponse(-1, MessageType.PENDANT_KEY, PendantKey.STOP.code(), tail),
            id),
        refused(() -> new InformationResponse(-1, information, tail), id),
        refused(() -> new FeaturesResponse(-1, new Features(Set.of()), tail), id),
        refused(() -> new BenchmarkResponse(-1, true, 0, 0, 0, 0, 0, tail), id),
        refused(() -> new ListDirectoryResponse(-1, List.of(), List.of(), tail), id),
        refused(() -> new FilePropertiesResponse(-1, FileProperties.NONE, tail), id),
        refused(
            () ->
                new ContentSizeResponse(
                    -1, MessageType.READ_CONTENT, ContentOperation.SIZE, 0, tail),
            id),
        refused(() -> new WriteDataResponse(-1, 0, 0, tail), id),
        refused(() -> new ReadDataResponse(-1, 0, Bytes.of(new byte[0]), tail), id),
        refused(() -> contentAnswer(-1, MessageType.READ_CONTENT, 4, tail), id),
        refused(() -> new PlainResponse(-1, MessageType.CONFIRM_ALL, tail), id));
  }

  private static ContentResponse contentAnswer(int id, MessageType type, int operation, Tail tail) {
    return new ContentResponse(id, type, new Code<>(ContentOperation.class, operation), tail);
  }

  static Stream<Arguments> wrongNumbers() {
    Code<Interpreter> robot = Code.of(Interpreter.ROBOT);
    return Stream.of(
        refused(
            () -> new ProgramControlRequest(0, new Code<>(ProgramCommand.class, 256), robot),
            "command must be 0 to 255, is 256"),
        refused(
            () ->
                new ProgramControlRequest(
                    0, Code.of(ProgramCommand.STOP), new Code<>(Interpreter.class, 32768)),
            "interpreter must be -32768 to 32767, is 32768"),
        refused(
            () ->
                new ProgramControlRequest(
                    0, Code.of(ProgramCommand.STOP), new Code<>(Interpreter.class, -32769)),
            "interpreter must be -32768 to 32767, is -32769"),
        refused(
            () -> new ProgramControlRequest(0, Code.of(ProgramCommand.RUN), robot),
            "command must not be SELECT or RUN, is RUN"),
        refused(
            () -> new ProgramSelectRequest(0, Code.of(ProgramCommand.STOP), robot, "", "", false),
            "command must be SELECT or RUN, is STOP"),
        refused(
            () -> new MotionRequest(0, new Code<>(MotionType.class, -1), ""),
            "motion must be 0 to 255, is -1"),
        refused(
            () -> new PendantKeyRequest(0, new Code<>(PendantKey.class, 256), 0, 0, true, true),
            "key must be 0 to 255, is 256"),
        refused(
            () -> new WriteMultipleRequest(0, 256, List.of()), "count must be 0 to 255, is 256"),
        refused(
            () -> new WriteMultipleRequest(0, 0, List.of(new Assignment("A", "1"))),
            "assignments must be 0 at most, are 1"),
        refused(
            () -> new BenchmarkReadRequest(0, 0x100000000L, List.of()),
            "iterations must be 0 to 4294967295, is 4294967296"),
        refused(
            () -> new BenchmarkWriteRequest(0, -1, List.of()),
            "iterations must be 0 to 4294967295, is -1"),
        refused(
            () ->
                new CreateFileRequest(
                    0,
                    new Code<>(ItemType.class, 65536),
                    Flags.none(ModulePart.class),
                    false,
                    "",
                    ""),
            "item type must be 0 to 65535, is 65536"),
        refused(
            () ->
                new CreateFileRequest(
                    0, Code.of(ItemType.MODULE), new Flags<>(ModulePart.class, 256), false, "", ""),
            "parts must be 0 to 255, is 256"),
        refused(() -> new BeginWriteRequest(0, -1), "size must be 0 to 4294967295, is -1"),
        refused(
            () -> new ReadDataRequest(0, 0x100000000L, 0),
            "offset must be 0 to 4294967295, is 4294967296"),
        refused(
            () -> new AccessResult(new Code<>(ErrorCode.class, 256), ""),
            "code must be 0 to 255, is 256"),
        refused(() -> new Features(Set.of(256)), "type must be 0 to 255, is 256"),
        refused(
            () -> new BenchmarkResponse(0, true, 256, 0, 0, 0, 0, Tail.SUCCESS),
            "count must be 0 to 255, is 256"),
        refused(
            () -> new BenchmarkResponse(0, true, 0, 0, 0, 0, -1, Tail.SUCCESS),
            "difference must be 0 to 4294967295, is -1"));
  }

  static Stream<Arguments> wrongTypes() {
    Flags<CopyFlag> copy = Flags.none(CopyFlag.class);
    return Stream.of(
        refused(
            () -> new ServerRequest(0, MessageType.READ),
            "type must be one of [INFORMATION, FEATURES, CONFIRM_ALL], is READ"),
        refused(
            () -> new CopyFileRequest(0, MessageType.FULL_NAME, copy, "", ""),
            "type must be one of [COPY_FILE, MOVE_FILE], is FULL_NAME"),
        refused(
            () -> new FileNameRequest(0, MessageType.COPY_FILE, ""),
            "type must be one of [FULL_NAME, KRC_NAME], is COPY_FILE"),
        refused(
            () -> new TextResponse(0, MessageType.READ, "", Tail.SUCCESS),
            "type must be one of [READ_UTF16, WRITE_UTF16, FULL_NAME, KRC_NAME], is READ"),
        refused(
            () -> new MultipleResponse(0, MessageType.READ, List.of(), Tail.SUCCESS),
            "type must be one of [READ_MULTIPLE, WRITE_MULTIPLE], is READ"),
        refused(
            () -> new PlainResponse(0, MessageType.READ, Tail.FAILURE),
            "an answer of type READ has a value"),
        refused(
            () -> new PlainResponse(0, MessageType.MOTION, Tail.SUCCESS),
            "type must be one of [SET_ATTRIBUTES, CREATE_FILE, DELETE_FILE, COPY_FILE, MOVE_FILE,"
                + " CONFIRM_ALL], is MOTION"),
        refused(
            () -> content(0, MessageType.MOTION, 3),
            "type must be one of [WRITE_CONTENT, READ_CONTENT], is MOTION"),
        refused(
            () -> content(0, MessageType.WRITE_CONTENT, 4),
            "operation END has fields in WRITE_CONTENT"),
        refused(
            () -> content(0, MessageType.READ_CONTENT, 1),
            "operation BEGIN has fields in READ_CONTENT"),
        refused(
            () -> content(0, MessageType.READ_CONTENT, 2),
            "operation DATA has fields in READ_CONTENT"),
        refused(
            () -> contentAnswer(0, MessageType.READ_CONTENT, 2, Tail.SUCCESS),
            "an answer of operation DATA has fields"),
        refused(
            () -> contentAnswer(0, MessageType.WRITE_CONTENT, 3, Tail.SUCCESS),
            "an answer of operation SIZE has fields"),
        refused(
            () ->
                new ContentSizeResponse(
                    0, MessageType.READ_CONTENT, ContentOperation.END, 0, Tail.SUCCESS),
            "operation must be BEGIN or SIZE, is END"));
  }

  static Stream<Arguments> tooLong() {
    String many = "n".repeat(40000);
    Bytes data = Bytes.of(new byte[65526]);
    return Stream.of(
        refused(() -> new ReadUtf16Request(0, many), frame("name", 80003)),
        refused(
            () -> new ReadUtf16Request(0, "n".repeat(32767)),
            "name needs a frame of 65537 bytes, a frame has 65535 at most"),
        refused(() -> new WriteUtf16Request(0, "", many), frame("name and value", 80005)),
        refused(
            () -> new ReadMultipleRequest(0, Collections.nCopies(256, "")),
            "names must be 255 at most, are 256"),
        refused(() -> new ReadMultipleRequest(0, List.of(many)), frame("names", 80004)),
        refused(
            () -> new WriteMultipleRequest(0, Collections.nCopies(256, new Assignment("", ""))),
            "assignments must be 255 at most, are 256"),
        refused(
            () -> new WriteMultipleRequest(0, List.of(new Assignment("", many))),
            frame("assignments", 80006)),
        refused(
            () ->
                new ProgramSelectRequest(
                    0, Code.of(ProgramCommand.RUN), Code.of(Interpreter.ROBOT), many, "", false),
            frame("name and parameters", 80009)),
        refused(
            () -> new MotionRequest(0, Code.of(MotionType.PTP), many), frame("position", 80004)),
        refused(
            () -> new BenchmarkReadRequest(0, 0, Collections.nCopies(256, "")),
            "names must be 255 at most, are 256"),
        refused(() -> new DeleteFileRequest(0, true, many), frame("name", 80004)),
        refused(() -> new WriteDataRequest(0, 0, data), frame("data", 65536)),
        refused(() -> new ReadDataResponse(0, 0, data, Tail.SUCCESS), frame("data", 65539)),
        refused(
            () -> new TextResponse(0, MessageType.READ_UTF16, many, Tail.SUCCESS),
            frame("text", 80006)),
        refused(
            () ->
                new ListDirectoryResponse(
                    0, List.of("n".repeat(20000)), List.of("n".repeat(20000)), Tail.SUCCESS),
            frame("items and infos", 80012)));
  }

  private static String frame(String field, int length) {
    return field + " needs a frame of " + length + " bytes, a frame has 65535 at most";
  }

  private static Arguments refused(Supplier<Object> constructor, String message) {
    return arguments(constructor, message);
  }

  @ParameterizedTest(name = "{1}")
  @MethodSource({"outOfRange", "answersOutOfRange", "wrongNumbers", "wrongTypes", "tooLong"})
  void aMessageThatNoFrameCanHoldIsRefusedWithFieldValueAndLimit(
      Supplier<Object> constructor, String message) {
    assertThatIllegalArgumentException().isThrownBy(constructor::get).withMessage(message);
  }

  @Test
  void aMessageKeepsTheItemsItWasMadeWith() {
    List<String> names = new ArrayList<>(List.of("A", "B"));
    ReadMultipleRequest request = new ReadMultipleRequest(0, names);
    Set<Integer> types = new HashSet<>(Set.of(1));
    Features features = new Features(types);

    names.set(0, "C");
    types.add(2);

    assertThat(request.names()).containsExactly("A", "B");
    assertThat(features.types()).containsExactly(1);
  }
}
