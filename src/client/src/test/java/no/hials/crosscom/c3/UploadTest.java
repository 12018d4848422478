package no.hials.crosscom.c3;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import no.hials.crosscom.CrossComClosedException;
import no.hials.crosscom.CrossComConnectionLostException;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComProtocolException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComTimeoutException;
import no.hials.crosscom.CrossComTransferException;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.file.Bytes;
import no.hials.crosscom.protocol.file.FileProperties;
import no.hials.crosscom.protocol.file.FileRequest.BeginWriteRequest;
import no.hials.crosscom.protocol.file.FileRequest.EndWriteRequest;
import no.hials.crosscom.protocol.file.FileResponse.ContentResponse;
import no.hials.crosscom.protocol.file.FileResponse.ContentSizeResponse;
import no.hials.crosscom.protocol.file.FileResponse.FilePropertiesResponse;
import no.hials.crosscom.protocol.file.FileResponse.ReadDataResponse;
import no.hials.crosscom.protocol.file.FileResponse.WriteDataResponse;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Uploads whole files or none. */
class UploadTest extends FilesRobotTest {
  private static final byte[] TWO_PARTS = bytes(PART + 1);
  private static final TransferConfig OVERWRITE = TransferConfig.create(c -> c.overwrite(true));

  @ParameterizedTest
  @ValueSource(ints = {0, 1, PART - 1, PART, PART + 1, 3_000_000})
  void whatIsUploadedIsThereAndCanBeDownloaded(int size) throws Exception {
    byte[] content = bytes(size);

    files.upload(content, FILE, TransferConfig.create(c -> c.verification(Verification.CONTENT)));

    assertThat(tree.get(FILE)).isEqualTo(content);
    assertThat(files.download(FILE)).isEqualTo(content);
    assertThat(received(Step.DATA)).hasSize((size + PART - 1) / PART);
  }

  @Test
  void aFileOfThisComputerIsUploaded(@TempDir Path folder) throws Exception {
    Path source = java.nio.file.Files.write(folder.resolve("test.src"), TWO_PARTS);

    files.upload(source, FILE);

    assertThat(tree.get(FILE)).isEqualTo(TWO_PARTS);
  }

  @Test
  void aFileOfThisComputerThatIsNotThereSendsNothing(@TempDir Path folder) {
    assertThatExceptionOfType(NoSuchFileException.class)
        .isThrownBy(() -> files.upload(folder.resolve("none"), FILE));
    assertThat(robot.requests()).isEmpty();
  }

  @Test
  void aTextKeepsItsLineEndsAndUmlauts() throws Exception {
    String text = "DEF test()\r\n; gr\u00fc\u00df\u00ff \u20ac \u2013 \nEND\r\n";

    files.uploadText(text, FILE, TransferConfig.DEFAULT);

    assertThat(tree.get(FILE)).isEqualTo(text.getBytes(Charset.forName("windows-1252")));
    assertThat(files.downloadText(FILE, TransferConfig.DEFAULT)).isEqualTo(text);
  }

  @Test
  void aTextThatIsNotWindows1252IsNotSent() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> files.uploadText("a\u03a9", FILE, TransferConfig.DEFAULT))
        .withMessage("the text must be Windows-1252, has U+03A9 at index 1");
    assertThat(robot.requests()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "\uFEFF"})
  void aTextThatAnEditorWroteInUtf8IsReadWithoutItsMark(String mark) throws Exception {
    String text = "; \u20ac \u03a9\nEND";
    tree.put(FILE, (mark + text).getBytes(StandardCharsets.UTF_8));

    assertThat(files.downloadText(FILE, TransferConfig.DEFAULT)).isEqualTo(text);
  }

  @Test
  void aNameMayHaveAnyCharacters() throws Exception {
    String name = "KRC:\\R1\\Program\\\u03a9\u20ac.txt";

    files.upload(TWO_PARTS, name);

    assertThat(tree.get(name)).isEqualTo(TWO_PARTS);
  }

  @Test
  void aBlankNameIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> files.upload(TWO_PARTS, " "))
        .withMessage("a file's name must not be blank");
  }

  @Test
  void aFileThatIsThereIsNotOverwrittenAndNothingOfTheNewOneIsSent() throws Exception {
    tree.put(FILE, "old");

    assertThatExceptionOfType(CrossComTransferException.class)
        .isThrownBy(() -> files.upload(TWO_PARTS, FILE))
        .withMessage(
            "the upload of "
                + FILE
                + " (nothing was stored) failed after 0 bytes: the file exists on the controller,"
                + " and overwrite is false")
        .satisfies(e -> assertThat(e.getFile()).isEqualTo(FILE));
    assertThat(tree.text(FILE)).contains("old");
    assertThat(received(Step.BEGIN)).isEmpty();
  }

  @Test
  void aFileThatAppearsMeanwhileIsNotOverwritten() throws Exception {
    assertThatExceptionOfType(CrossComRefusedException.class)
        .isThrownBy(() -> files.upload(TWO_PARTS, FILE, onProgress(() -> tree.put(FILE, "new"))))
        .satisfies(e -> assertThat(e.getErrorCode()).contains(ErrorCode.ACCESS));
    assertThat(tree.text(FILE)).contains("new");
  }

  @Test
  void aFileIsOverwrittenIfAskedFor() throws Exception {
    tree.put(FILE, "old");

    files.upload(TWO_PARTS, FILE, OVERWRITE);

    assertThat(tree.get(FILE)).isEqualTo(TWO_PARTS);
  }

  @Test
  void flagsAreSentAsTheyAre() throws Exception {
    TransferConfig config =
        TransferConfig.create(
            c -> c.overwrite(true).flags(CopyFlag.FORCE_TEXT, CopyFlag.NO_KRL_ANALYSIS));

    files.upload(bytes(1), FILE, config);

    assertThat(received(Step.END))
        .singleElement()
        .isInstanceOfSatisfying(
            EndWriteRequest.class,
            end ->
                assertThat(end.flags())
                    .isEqualTo(
                        Flags.of(
                            CopyFlag.OVERWRITE, CopyFlag.FORCE_TEXT, CopyFlag.NO_KRL_ANALYSIS)));
  }

  @Test
  void progressIsToldAtTheBeginningAndAfterEachPart() throws Exception {
    List<Long> told = new ArrayList<>();

    files.upload(
        bytes(2 * PART + 1),
        FILE,
        TransferConfig.create(
            c ->
                c.progress(
                    (done, total) -> {
                      assertThat(total).isEqualTo(2 * PART + 1);
                      told.add(done);
                    })));

    assertThat(told).containsExactly(0L, (long) PART, 2L * PART, 2L * PART + 1);
  }

  // --- whatever goes wrong, there is no half file

  static Stream<Arguments> stepsAndFaults() {
    List<Fault> faults =
        List.of(
            Fault.closeBefore(),
            Fault.resetBefore(),
            Fault.closeDuring(3),
            Fault.drop(),
            Fault.dropAnswer(),
            Fault.wrongId(),
            Fault.wrongFunction(63),
            Fault.truncate(2),
            Fault.emptyAnswer(),
            Fault.garbage(20, 1));
    return Step.ofUpload().flatMap(step -> faults.stream().map(f -> Arguments.of(step, f)));
  }

  @ParameterizedTest
  @MethodSource("stepsAndFaults")
  void aFaultAtAnyStepLeavesTheWholeFileOrNone(Step step, Fault fault) throws Exception {
    TransferConfig config = hastyFrom(step, client);
    once(step, fault);
    CrossComException failure = null;
    try {
      files.upload(TWO_PARTS, FILE, config);
    } catch (CrossComException e) {
      failure = e;
    }
    client.setSoTimeout(0);

    // looking whether it is there is repeated on a new connection, and what is stored is stored
    boolean repeated =
        step == Step.EXISTS
            && (fault == Fault.closeBefore()
                || fault == Fault.resetBefore()
                || fault instanceof Fault.CloseDuring);
    boolean stored = repeated || (step == Step.END && fault.executes());
    assertThat(tree.exists(FILE)).isEqualTo(stored);
    if (stored) {
      assertThat(tree.get(FILE)).isEqualTo(TWO_PARTS);
    }
    if (repeated) {
      assertThat(failure).isNull();
    } else {
      assertThat(failure)
          .isInstanceOfAny(
              CrossComConnectionLostException.class,
              CrossComTimeoutException.class,
              CrossComProtocolException.class);
      assertThat(failure.isOutcomeUnknown()).isEqualTo(step == Step.END);
      assertThat(failure.getMessage().contains("nothing was stored")).isEqualTo(step != Step.END);
    }
    // the client goes on
    files.upload(TWO_PARTS, FILE, OVERWRITE);
    assertThat(tree.get(FILE)).isEqualTo(TWO_PARTS);
  }

  static Stream<Arguments> stepsAndCodes() {
    return Step.ofUpload()
        .filter(step -> step != Step.EXISTS)
        .flatMap(
            step ->
                IntStream.of(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 65_535)
                    .mapToObj(code -> Arguments.of(step, code)));
  }

  @ParameterizedTest
  @MethodSource("stepsAndCodes")
  void aRefusalAtAnyStepHasItsCodeAndLeavesNothing(Step step, int code) throws Exception {
    ContentOperation operation = ContentOperation.valueOf(step.name());
    lie(
        step,
        id ->
            new ContentResponse(
                id, MessageType.WRITE_CONTENT, Code.of(operation), new Tail(code, 0)));

    assertThatExceptionOfType(CrossComRefusedException.class)
        .isThrownBy(() -> files.upload(TWO_PARTS, FILE))
        .withMessageContaining("upload of " + FILE)
        .satisfies(e -> assertThat(e.getCode()).isEqualTo(code));
    assertThat(tree.exists(FILE)).isFalse();
    assertThat(client.getServer()).isNotNull();
  }

  @Test
  void aRefusalOfTheLookOtherThanNotThereEndsTheUpload() {
    lie(Step.EXISTS, id -> new FilePropertiesResponse(id, FileProperties.NONE, new Tail(8, 0)));

    assertThatExceptionOfType(CrossComRefusedException.class)
        .isThrownBy(() -> files.upload(TWO_PARTS, FILE))
        .satisfies(e -> assertThat(e.getErrorCode()).contains(ErrorCode.NO_INTERFACE));
    assertThat(received(Step.BEGIN)).isEmpty();
  }

  static Stream<Arguments> lies() {
    return Stream.of(
        Arguments.of(Step.BEGIN, size(ContentOperation.BEGIN, TWO_PARTS.length - 1)),
        Arguments.of(Step.BEGIN, size(ContentOperation.BEGIN, 0xFFFF_FFFFL)),
        Arguments.of(Step.BEGIN, size(ContentOperation.SIZE, TWO_PARTS.length)),
        Arguments.of(Step.DATA, written(0, 0)),
        Arguments.of(Step.DATA, written(0, PART - 1)),
        Arguments.of(Step.DATA, written(0, PART + 1)),
        Arguments.of(Step.DATA, written(0, 0xFFFF_FFFFL)),
        Arguments.of(Step.DATA, written(1, PART)),
        Arguments.of(Step.DATA, written(0xFFFF_FFFFL, PART)),
        Arguments.of(Step.SIZE, size(ContentOperation.SIZE, 0)),
        Arguments.of(Step.SIZE, size(ContentOperation.BEGIN, TWO_PARTS.length)));
  }

  private static Function<Integer, Response> size(ContentOperation operation, long size) {
    return id ->
        new ContentSizeResponse(id, MessageType.WRITE_CONTENT, operation, size, Tail.SUCCESS);
  }

  private static Function<Integer, Response> written(long offset, long count) {
    return id -> new WriteDataResponse(id, offset, count, Tail.SUCCESS);
  }

  @ParameterizedTest
  @MethodSource("lies")
  void aServerThatDidNotTakeWhatWasSentIsNotAskedToStoreIt(
      Step step, Function<Integer, Response> answer) {
    lie(step, answer);

    assertThatExceptionOfType(CrossComTransferException.class)
        .isThrownBy(() -> files.upload(TWO_PARTS, FILE))
        .withMessageContaining("the server");
    assertThat(received(Step.END)).isEmpty();
    assertThat(tree.exists(FILE)).isFalse();
  }

  @Test
  void theServersBufferIsEmptiedWhenAnUploadFails() {
    lie(Step.DATA, written(0, 0));

    assertThatExceptionOfType(CrossComTransferException.class)
        .isThrownBy(() -> files.upload(TWO_PARTS, FILE));
    assertThat(robot.requests())
        .last()
        .satisfies(r -> assertThat(r.request()).isInstanceOf(BeginWriteRequest.class))
        .satisfies(r -> assertThat(((BeginWriteRequest) r.request()).size()).isZero());
  }

  @Test
  void aRefusedNameIsReportedAsARefusedUpload() {
    assertThatExceptionOfType(CrossComRefusedException.class)
        .isThrownBy(() -> files.upload(TWO_PARTS, "KRC:\\R1\\..\\..\\E.SRC"))
        .withMessageStartingWith(
            "the server refused the upload of KRC:\\R1\\..\\..\\E.SRC (nothing was stored): code");
  }

  // --- verification of what is stored

  @Test
  void aStoredFileOfAnotherSizeIsReported() {
    lie(Step.EXISTS, id -> new FilePropertiesResponse(id, FileProperties.NONE, Tail.SUCCESS));

    assertThatExceptionOfType(CrossComTransferException.class)
        .isThrownBy(() -> files.upload(TWO_PARTS, FILE, OVERWRITE))
        .withMessageContaining("the file is stored, but has 0 bytes instead of 64513")
        .satisfies(e -> assertThat(e.getBytes()).isEqualTo(TWO_PARTS.length));
  }

  @Test
  void aStoredFileIsNotLookedAtIfThePartsAreEnough() throws Exception {
    files.upload(
        TWO_PARTS,
        FILE,
        TransferConfig.create(c -> c.overwrite(true).verification(Verification.PARTS)));

    assertThat(received(Step.EXISTS)).isEmpty();
    assertThat(tree.get(FILE)).isEqualTo(TWO_PARTS);
  }

  @Test
  void aStoredFileOfTheSameSizeAndOtherContentIsReported() {
    byte[] other = TWO_PARTS.clone();
    other[0]++;
    lie(Step.READ_DATA, id -> new ReadDataResponse(id, 0, Bytes.of(other, 0, PART), Tail.SUCCESS));

    assertThatExceptionOfType(CrossComTransferException.class)
        .isThrownBy(
            () ->
                files.upload(
                    TWO_PARTS,
                    FILE,
                    TransferConfig.create(c -> c.verification(Verification.CONTENT))))
        .withMessageContaining("the file is stored, but its content differs from the content sent");
  }

  @ParameterizedTest
  @EnumSource(names = {"EXISTS", "BEGIN_READ", "READ_DATA", "READ_SIZE"})
  void aVerificationThatBreaksReportsThatTheFileIsStored(Step step) throws Exception {
    robot.fault(step::is, Fault.closeBefore());

    assertThatExceptionOfType(CrossComConnectionLostException.class)
        .isThrownBy(
            () ->
                files.upload(
                    TWO_PARTS,
                    FILE,
                    TransferConfig.create(
                        c -> c.overwrite(true).verification(Verification.CONTENT))))
        .withMessageContaining(
            "broke during the verification of "
                + FILE
                + " (the file is stored but was not verified): ");
    assertThat(tree.get(FILE)).isEqualTo(TWO_PARTS);
  }

  // --- failures of this side

  @ParameterizedTest
  @ValueSource(longs = {0, PART, PART + 2, 200_000})
  void aStreamOfAnotherLengthThanAnnouncedIsNotStored(long size) {
    assertThatExceptionOfType(CrossComTransferException.class)
        .isThrownBy(
            () ->
                files.upload(
                    new ByteArrayInputStream(TWO_PARTS), size, FILE, TransferConfig.DEFAULT))
        .withMessageContaining("the content must have " + size + " bytes, has ");
    assertThat(tree.exists(FILE)).isFalse();
  }

  @Test
  void aSizeThatNoMessageCanAnnounceIsRefused() {
    assertThatExceptionOfType(CrossComTransferException.class)
        .isThrownBy(
            () ->
                files.upload(InputStream.nullInputStream(), 1L << 32, FILE, TransferConfig.DEFAULT))
        .withMessageContaining("a file must have at most 4294967295 bytes, has 4294967296");
    assertThatIllegalArgumentException()
        .isThrownBy(
            () -> files.upload(InputStream.nullInputStream(), -1, FILE, TransferConfig.DEFAULT))
        .withMessage("size must be 0 or more, is -1");
    assertThat(robot.requests()).isEmpty();
  }

  @Test
  void aStreamThatFailsStoresNothingAndItsExceptionComesOut() {
    IOException broken = new IOException("broken");
    InputStream stream =
        new InputStream() {
          @Override
          public int read() throws IOException {
            throw broken;
          }

          @Override
          public int read(byte[] target, int offset, int length) throws IOException {
            throw broken;
          }
        };

    assertThatThrownBy(() -> files.upload(stream, 1, FILE, TransferConfig.DEFAULT))
        .isSameAs(broken);
    assertThat(tree.exists(FILE)).isFalse();
  }

  @Test
  void aListenerThatThrowsEndsTheUploadAndNothingIsStored() {
    IllegalStateException stop = new IllegalStateException("stop");

    assertThatThrownBy(
            () ->
                files.upload(
                    TWO_PARTS,
                    FILE,
                    onProgress(
                        () -> {
                          throw stop;
                        })))
        .isSameAs(stop);
    assertThat(tree.exists(FILE)).isFalse();
  }

  @Test
  void aTransferInsideATransferIsRefused() {
    assertThatIllegalStateException()
        .isThrownBy(() -> files.upload(TWO_PARTS, FILE, onProgress(() -> files.download(FILE))))
        .withMessageContaining("while the same thread does another transfer");
    assertThat(tree.exists(FILE)).isFalse();
  }

  // --- a connection lost in the middle

  @Test
  void anUploadDoesNotGoOnWithABufferOfAnotherConnection() throws Exception {
    assertThatExceptionOfType(CrossComConnectionLostException.class)
        .isThrownBy(
            () ->
                files.upload(
                    TWO_PARTS,
                    FILE,
                    onProgress(
                        () -> {
                          robot.disconnectClients();
                          client.readText("$OV_PRO"); // on a new connection
                        })))
        .satisfies(e -> assertThat(e.isOutcomeUnknown()).isFalse());
    assertThat(received(Step.DATA)).hasSize(1);
    assertThat(received(Step.END)).isEmpty();
    assertThat(tree.exists(FILE)).isFalse();
    files.upload(TWO_PARTS, FILE);
    assertThat(tree.get(FILE)).isEqualTo(TWO_PARTS);
  }

  @Test
  void closingTheClientEndsAnUpload() {
    assertThatExceptionOfType(CrossComClosedException.class)
        .isThrownBy(() -> files.upload(TWO_PARTS, FILE, onProgress(client::close)));
    assertThat(tree.exists(FILE)).isFalse();
  }
}
