package no.hials.crosscom.c3;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
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
import no.hials.crosscom.protocol.file.Bytes;
import no.hials.crosscom.protocol.file.FileRequest.ReadDataRequest;
import no.hials.crosscom.protocol.file.FileResponse.ContentResponse;
import no.hials.crosscom.protocol.file.FileResponse.ContentSizeResponse;
import no.hials.crosscom.protocol.file.FileResponse.ReadDataResponse;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Downloads whole files or none. */
class DownloadTest extends FilesRobotTest {
  private static final byte[] TWO_PARTS = bytes(PART + 1);
  private static final TransferConfig OVERWRITE = TransferConfig.create(c -> c.overwrite(true));

  @TempDir Path folder;
  Path target;

  @BeforeEach
  void putFile() throws Exception {
    tree.put(FILE, TWO_PARTS);
    target = folder.resolve("test.src");
  }

  private List<Path> local() throws IOException {
    try (Stream<Path> found = java.nio.file.Files.list(folder)) {
      return found.toList();
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, PART - 1, PART, PART + 1, 3_000_000})
  void aFileComesToThisComputer(int size) throws Exception {
    byte[] content = bytes(size);
    tree.put(FILE, content);

    files.download(FILE, target);

    assertThat(java.nio.file.Files.readAllBytes(target)).isEqualTo(content);
    assertThat(local()).containsExactly(target);
    assertThat(received(Step.READ_DATA)).hasSize((size + PART - 1) / PART);
  }

  @Test
  void noMoreThanAPartIsAskedFor() throws Exception {
    files.download(FILE);

    assertThat(received(Step.READ_DATA))
        .extracting(r -> ((ReadDataRequest) r).size())
        .containsExactly((long) PART, 1L);
  }

  @Test
  void progressIsToldAtTheBeginningAndAfterEachPart() throws Exception {
    List<Long> told = new ArrayList<>();

    files.download(
        FILE,
        TransferConfig.create(
            c ->
                c.progress(
                    (done, total) -> {
                      assertThat(total).isEqualTo(TWO_PARTS.length);
                      told.add(done);
                    })));

    assertThat(told).containsExactly(0L, (long) PART, PART + 1L);
  }

  @Test
  void aFileThatIsNotThereIsRefused() throws Exception {
    assertThatExceptionOfType(CrossComRefusedException.class)
        .isThrownBy(() -> files.download("KRC:\\R1\\Program\\none.src", target))
        .satisfies(e -> assertThat(e.getErrorCode()).contains(ErrorCode.GENERAL));
    assertThat(local()).isEmpty();
  }

  @Test
  void aFileOfThisComputerIsNotOverwrittenAndNothingIsSent() throws Exception {
    java.nio.file.Files.writeString(target, "old");

    assertThatExceptionOfType(FileAlreadyExistsException.class)
        .isThrownBy(() -> files.download(FILE, target));
    assertThat(target).hasContent("old");
    assertThat(robot.requests()).isEmpty();
  }

  @Test
  void aFileOfThisComputerThatAppearsMeanwhileIsNotOverwritten() throws Exception {
    assertThatExceptionOfType(FileAlreadyExistsException.class)
        .isThrownBy(
            () ->
                files.download(
                    FILE,
                    target,
                    onProgress(() -> java.nio.file.Files.writeString(target, "new"))));
    assertThat(target).hasContent("new");
    assertThat(local()).containsExactly(target);
  }

  @Test
  void aFileOfThisComputerIsOverwrittenIfAskedFor() throws Exception {
    java.nio.file.Files.writeString(target, "old");

    files.download(FILE, target, OVERWRITE);

    assertThat(target).hasBinaryContent(TWO_PARTS);
    assertThat(local()).containsExactly(target);
  }

  @Test
  @EnabledOnOs({OS.LINUX, OS.MAC})
  void aLinkStaysALinkAndItsFileIsOverwritten() throws Exception {
    Path file = java.nio.file.Files.writeString(folder.resolve("linked.src"), "old");
    Path link = target;
    java.nio.file.Files.createSymbolicLink(link, file);

    files.download(FILE, link, OVERWRITE);

    assertThat(link).isSymbolicLink().hasBinaryContent(TWO_PARTS);
    assertThat(file).isRegularFile();
    assertThat(local()).containsExactlyInAnyOrder(link, file);
  }

  @Test
  @EnabledOnOs({OS.LINUX, OS.MAC})
  void aPipeAndALinkToNothingAreNotReplaced() throws Exception {
    Path link = java.nio.file.Files.createSymbolicLink(folder.resolve("link"), Path.of("nothing"));
    new ProcessBuilder("mkfifo", target.toString()).start().waitFor();

    for (Path special : List.of(target, link)) {
      assertThatThrownBy(() -> files.download(FILE, special, OVERWRITE))
          .isInstanceOf(FileSystemException.class)
          .hasMessage(special + ": it is not a regular file");
    }

    assertThat(java.nio.file.Files.isSymbolicLink(link)).isTrue();
    assertThat(java.nio.file.Files.isRegularFile(target)).isFalse();
    assertThat(local()).containsExactlyInAnyOrder(target, link);
  }

  @Test
  void aFileOfThisComputerStaysAsItWasIfTheDownloadFails() throws Exception {
    java.nio.file.Files.writeString(target, "old");
    once(Step.READ_SIZE, Fault.closeBefore());

    assertThatExceptionOfType(CrossComConnectionLostException.class)
        .isThrownBy(() -> files.download(FILE, target, OVERWRITE));
    assertThat(target).hasContent("old");
    assertThat(local()).containsExactly(target);
  }

  @Test
  void aDirectoryThatIsNotThereIsNoticedBeforeAnythingIsSent() {
    assertThatExceptionOfType(NoSuchFileException.class)
        .isThrownBy(() -> files.download(FILE, folder.resolve("none").resolve("test.src")));
    assertThat(robot.requests()).isEmpty();
  }

  static Stream<Arguments> stepsAndFaults() {
    List<Fault> faults =
        List.of(
            Fault.closeBefore(),
            Fault.resetBefore(),
            Fault.closeDuring(3),
            Fault.drop(),
            Fault.wrongId(),
            Fault.wrongFunction(63),
            Fault.truncate(2),
            Fault.emptyAnswer(),
            Fault.garbage(20, 1));
    return Step.ofDownload().flatMap(step -> faults.stream().map(f -> Arguments.of(step, f)));
  }

  @ParameterizedTest
  @MethodSource("stepsAndFaults")
  void aFaultAtAnyStepLeavesNoFile(Step step, Fault fault) throws Exception {
    TransferConfig config = hastyFrom(step, client);
    once(step, fault);

    assertThatExceptionOfType(CrossComException.class)
        .isThrownBy(() -> files.download(FILE, target, config))
        .isInstanceOfAny(
            CrossComConnectionLostException.class,
            CrossComTimeoutException.class,
            CrossComProtocolException.class)
        .satisfies(e -> assertThat(e.isOutcomeUnknown()).isFalse());
    assertThat(local()).isEmpty();
    // the client goes on
    client.setSoTimeout(0);
    files.download(FILE, target);
    assertThat(target).hasBinaryContent(TWO_PARTS);
  }

  static Stream<Arguments> stepsAndCodes() {
    return Step.ofDownload()
        .flatMap(
            step -> IntStream.of(0, 1, 2, 9, 10, 11).mapToObj(code -> Arguments.of(step, code)));
  }

  @ParameterizedTest
  @MethodSource("stepsAndCodes")
  void aRefusalAtAnyStepHasItsCodeAndLeavesNoFile(Step step, int code) throws Exception {
    ContentOperation operation =
        ContentOperation.valueOf(step.name().replaceFirst("READ_", "").replaceFirst("_READ", ""));
    lie(
        step,
        id ->
            new ContentResponse(
                id, MessageType.READ_CONTENT, Code.of(operation), new Tail(code, 0)));

    assertThatExceptionOfType(CrossComRefusedException.class)
        .isThrownBy(() -> files.download(FILE, target))
        .withMessageContaining("download of " + FILE)
        .satisfies(e -> assertThat(e.getCode()).isEqualTo(code));
    assertThat(local()).isEmpty();
  }

  static Stream<Arguments> lies() {
    return Stream.of(
        Arguments.of(Step.BEGIN_READ, size(ContentOperation.BEGIN, TWO_PARTS.length - 1)),
        Arguments.of(Step.BEGIN_READ, size(ContentOperation.BEGIN, TWO_PARTS.length + 1)),
        Arguments.of(Step.BEGIN_READ, size(ContentOperation.BEGIN, 0xFFFF_FFFFL)),
        Arguments.of(Step.BEGIN_READ, size(ContentOperation.SIZE, TWO_PARTS.length)),
        Arguments.of(Step.READ_DATA, data(0, 0)),
        Arguments.of(Step.READ_DATA, data(0, PART + 1)),
        Arguments.of(Step.READ_DATA, data(1, PART)),
        Arguments.of(Step.READ_DATA, data(0xFFFF_FFFFL, PART)),
        Arguments.of(Step.READ_SIZE, size(ContentOperation.SIZE, TWO_PARTS.length + 1)),
        Arguments.of(Step.READ_SIZE, size(ContentOperation.BEGIN, TWO_PARTS.length)));
  }

  private static Function<Integer, Response> size(ContentOperation operation, long size) {
    return id ->
        new ContentSizeResponse(id, MessageType.READ_CONTENT, operation, size, Tail.SUCCESS);
  }

  private static Function<Integer, Response> data(long offset, int count) {
    return id -> new ReadDataResponse(id, offset, Bytes.of(new byte[count]), Tail.SUCCESS);
  }

  @ParameterizedTest
  @MethodSource("lies")
  void whatTheServerDidNotAnnounceIsNoFile(Step step, Function<Integer, Response> answer)
      throws Exception {
    lie(step, answer);

    assertThatExceptionOfType(CrossComTransferException.class)
        .isThrownBy(() -> files.download(FILE, target))
        .withMessageContaining("the server");
    assertThat(local()).isEmpty();
    assertThat(files.download(FILE)).isEqualTo(TWO_PARTS);
  }

  @Test
  void aChunkWhoseLengthIsMoreThanItHasIsNoAnswer() throws Exception {
    robot.fault(Step.READ_DATA::is, Fault.wrongLength(1));
    TransferConfig config = hastyFrom(Step.READ_DATA, client);

    assertThatExceptionOfType(CrossComException.class)
        .isThrownBy(() -> files.download(FILE, target, config));
    assertThat(local()).isEmpty();
  }

  @Test
  void shorterPartsThanAskedForArePutTogether() throws Exception {
    lie(Step.READ_DATA, id -> new ReadDataResponse(id, 0, Bytes.of(TWO_PARTS, 0, 1), Tail.SUCCESS));

    assertThat(files.download(FILE)).isEqualTo(TWO_PARTS);
  }

  @Test
  void aClaimedSizeTakesNoMemory() {
    lie(Step.BEGIN_READ, size(ContentOperation.BEGIN, 0xFFFF_FFFFL));

    assertThatExceptionOfType(CrossComTransferException.class)
        .isThrownBy(() -> files.download(FILE))
        .withMessageContaining("the file must have at most 67108864 bytes, has 4294967295");
    assertThat(received(Step.READ_DATA)).isEmpty();
  }

  @Test
  void aFileThatIsReplacedDuringItsDownloadComesAsItWasAtTheBeginning() throws Exception {
    byte[] content = files.download(FILE, onProgress(() -> tree.put(FILE, bytes(3 * PART))));

    assertThat(content).isEqualTo(TWO_PARTS);
  }

  @Test
  void aFileThatIsReplacedDuringItsDownloadIsNoticedIfTheContentIsCompared() {
    TransferProgress replace =
        (done, total) -> {
          try {
            tree.put(FILE, bytes(1));
          } catch (IOException e) {
            throw new AssertionError(e);
          }
        };

    assertThatExceptionOfType(CrossComTransferException.class)
        .isThrownBy(
            () ->
                files.download(
                    FILE,
                    target,
                    TransferConfig.create(
                        c -> c.progress(replace).verification(Verification.CONTENT))))
        .withMessageContaining("the file that came a second time to compare is different");
    assertThat(target).doesNotExist();
  }

  @Test
  void aComparedDownloadIsTheFile() throws Exception {
    TransferConfig compared = TransferConfig.create(c -> c.verification(Verification.CONTENT));

    assertThat(files.download(FILE, compared)).isEqualTo(TWO_PARTS);
    assertThat(received(Step.BEGIN_READ)).hasSize(2);
  }

  @Test
  void aDownloadDoesNotGoOnWithABufferOfAnotherConnection() throws Exception {
    assertThatExceptionOfType(CrossComConnectionLostException.class)
        .isThrownBy(
            () ->
                files.download(
                    FILE,
                    target,
                    onProgress(
                        () -> {
                          robot.disconnectClients();
                          client.readText("$OV_PRO"); // on a new connection
                        })));
    assertThat(received(Step.READ_DATA)).hasSize(1);
    assertThat(local()).isEmpty();
  }

  @Test
  void aListenerThatThrowsEndsTheDownload() throws Exception {
    IllegalStateException stop = new IllegalStateException("stop");

    assertThatThrownBy(
            () ->
                files.download(
                    FILE,
                    target,
                    onProgress(
                        () -> {
                          throw stop;
                        })))
        .isSameAs(stop);
    assertThat(local()).isEmpty();
  }
}
