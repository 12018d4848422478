package no.hials.crosscom.c3;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import no.hials.crosscom.CrossComClosedException;
import no.hials.crosscom.CrossComTransferException;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.file.FileRequest.BeginWriteRequest;
import no.hials.crosscom.protocol.file.FileRequest.EndWriteRequest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Transfers of several threads, and those of the client's own. */
class TransferThreadsTest extends FilesRobotTest {
  private static final byte[] TWO_PARTS = bytes(PART + 1);
  private static final String OTHER = "KRC:\\R1\\Program\\other.src";

  @Test
  void othersReadVariablesBetweenTheParts() throws Exception {
    files.upload(
        TWO_PARTS,
        FILE,
        onProgress(() -> client.async(c -> c.readText("$OV_PRO")).get(60, TimeUnit.SECONDS)));

    List<MessageType> between =
        robot.requests().stream()
            .map(RecordedRequest::request)
            .dropWhile(r -> !Step.DATA.matches(r))
            .skip(1)
            .takeWhile(r -> !Step.DATA.matches(r))
            .map(Request::type)
            .toList();
    assertThat(between).containsExactly(MessageType.READ);
    assertThat(tree.get(FILE)).isEqualTo(TWO_PARTS);
  }

  @Test
  void thePartsOfTwoUploadsDoNotMix() throws Exception {
    byte[] content = bytes(3 * PART);
    byte[] other = bytes(3 * PART + 1);
    CompletableFuture<Void> first = files.uploadAsync(content, FILE, TransferConfig.DEFAULT);
    Thread reader = new Thread(() -> readUntil(first));
    reader.start();

    files.upload(other, OTHER); // by this thread, at the same time
    first.get(60, TimeUnit.SECONDS);
    reader.join();

    assertThat(tree.get(FILE)).isEqualTo(content);
    assertThat(tree.get(OTHER)).isEqualTo(other);
    List<Boolean> begun = new ArrayList<>();
    for (RecordedRequest recorded : robot.requests()) {
      if (recorded.request() instanceof BeginWriteRequest) {
        begun.add(true);
      } else if (recorded.request() instanceof EndWriteRequest) {
        begun.add(false);
      }
    }
    assertThat(begun).containsExactly(true, false, true, false);
  }

  private void readUntil(CompletableFuture<?> end) {
    try {
      do {
        client.readText("$OV_PRO");
      } while (!end.isDone());
    } catch (java.io.IOException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void aTransferThatIsCancelledInTheMiddleLeavesNothing(@TempDir Path folder) throws Exception {
    tree.put(OTHER, TWO_PARTS);
    AtomicReference<CompletableFuture<Void>> running = new AtomicReference<>();
    CountDownLatch known = new CountDownLatch(1);
    TransferConfig cancelling =
        onProgress(
            () -> {
              known.await();
              assertThat(running.get().cancel(true)).isTrue();
            });

    running.set(files.uploadAsync(TWO_PARTS, FILE, cancelling));
    known.countDown();
    assertThatExceptionOfType(CancellationException.class).isThrownBy(() -> running.get().join());
    client.async(c -> c.files().exists(FILE)).get(60, TimeUnit.SECONDS);
    files.downloadAsync(OTHER, TransferConfig.DEFAULT).get(60, TimeUnit.SECONDS); // runs after it
    assertThat(tree.exists(FILE)).isFalse();
    assertThat(received(Step.END)).isEmpty();
  }

  @Test
  void aDownloadThatIsCancelledInTheMiddleLeavesNoFile(@TempDir Path folder) throws Exception {
    tree.put(FILE, TWO_PARTS);
    AtomicReference<CompletableFuture<Void>> running = new AtomicReference<>();
    CountDownLatch known = new CountDownLatch(1);
    TransferConfig cancelling =
        onProgress(
            () -> {
              known.await();
              assertThat(running.get().cancel(true)).isTrue();
            });

    running.set(files.downloadAsync(FILE, folder.resolve("test.src"), cancelling));
    known.countDown();
    assertThatExceptionOfType(CancellationException.class).isThrownBy(() -> running.get().join());
    files.downloadAsync(FILE, TransferConfig.DEFAULT).get(60, TimeUnit.SECONDS); // runs after it
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void anUploadThatIsBeingStoredIsNotCancelled() throws Exception {
    CountDownLatch stored = new CountDownLatch(1);
    CountDownLatch asked = new CountDownLatch(1);
    robot.fault(
        r -> {
          boolean end = Step.END.is(r);
          if (end) {
            asked.countDown();
          }
          return end;
        },
        Fault.hold(stored));

    CompletableFuture<Void> upload = files.uploadAsync(TWO_PARTS, FILE, TransferConfig.DEFAULT);
    assertThat(asked.await(60, TimeUnit.SECONDS)).isTrue();
    assertThat(upload.cancel(true)).isFalse();
    stored.countDown();
    upload.get(60, TimeUnit.SECONDS);
    assertThat(tree.get(FILE)).isEqualTo(TWO_PARTS);
  }

  @Test
  void aTransferThatIsCancelledBeforeItsTurnSendsNothing() throws Exception {
    CountDownLatch released = new CountDownLatch(1);
    once(Step.DATA, Fault.hold(released));
    CompletableFuture<Void> first = files.uploadAsync(TWO_PARTS, FILE, TransferConfig.DEFAULT);

    CompletableFuture<Void> second = files.uploadAsync(TWO_PARTS, OTHER, TransferConfig.DEFAULT);
    assertThat(second.cancel(true)).isTrue();
    released.countDown();
    first.get(60, TimeUnit.SECONDS);
    files.downloadAsync(FILE, TransferConfig.DEFAULT).get(60, TimeUnit.SECONDS); // runs after both
    assertThat(received(Step.BEGIN)).hasSize(1);
    assertThat(tree.exists(OTHER)).isFalse();
  }

  @Test
  void aThreadThatIsInterruptedWhileItWaitsForItsTurnSendsNothing() throws Exception {
    CountDownLatch begun = new CountDownLatch(1);
    CountDownLatch released = new CountDownLatch(1);
    robot.fault(
        r -> {
          if (Step.DATA.is(r)) {
            begun.countDown();
          }
          return Step.DATA.is(r);
        },
        Fault.hold(released));
    CompletableFuture<Void> first = files.uploadAsync(TWO_PARTS, FILE, TransferConfig.DEFAULT);
    assertThat(begun.await(60, TimeUnit.SECONDS)).isTrue();
    AtomicReference<Throwable> failure = new AtomicReference<>();
    AtomicReference<Boolean> flag = new AtomicReference<>();
    Thread second =
        new Thread(
            () -> {
              try {
                files.upload(TWO_PARTS, OTHER);
              } catch (Exception e) {
                failure.set(e);
                flag.set(Thread.currentThread().isInterrupted());
              }
            });
    second.start();
    second.interrupt();
    second.join();
    released.countDown();
    first.get(60, TimeUnit.SECONDS);

    assertThat(failure.get())
        .isInstanceOf(CrossComTransferException.class)
        .hasMessageEndingWith("the thread was interrupted before its turn came");
    assertThat(flag.get()).isTrue();
    assertThat(tree.exists(OTHER)).isFalse();
  }

  @Test
  void transfersEndWithTheClient() throws Exception {
    CountDownLatch released = new CountDownLatch(1);
    once(Step.DATA, Fault.hold(released));
    CompletableFuture<Void> first = files.uploadAsync(TWO_PARTS, FILE, TransferConfig.DEFAULT);
    CompletableFuture<Void> second = files.uploadAsync(TWO_PARTS, OTHER, TransferConfig.DEFAULT);
    client.close();
    released.countDown();

    for (CompletableFuture<Void> transfer :
        List.of(first, second, files.uploadAsync(TWO_PARTS, OTHER, TransferConfig.DEFAULT))) {
      assertThatExceptionOfType(ExecutionException.class)
          .isThrownBy(() -> transfer.get(60, TimeUnit.SECONDS))
          .withCauseInstanceOf(CrossComClosedException.class);
    }
    assertThat(tree.exists(FILE)).isFalse();
  }

  @Test
  void aFailedTransferOfAnotherThreadHasItsException() throws Exception {
    tree.put(FILE, "old");

    assertThatExceptionOfType(ExecutionException.class)
        .isThrownBy(
            () ->
                files
                    .uploadAsync(TWO_PARTS, FILE, TransferConfig.DEFAULT)
                    .get(60, TimeUnit.SECONDS))
        .withCauseInstanceOf(CrossComTransferException.class);
  }

  @Test
  @SuppressWarnings("NullAway") // on purpose
  void theTwinsOfTransfersRefuseNullAtOnce() {
    TransferConfig config = TransferConfig.DEFAULT;

    assertThatNullPointerException()
        .isThrownBy(() -> files.uploadAsync((byte[]) null, FILE, config))
        .withMessage("content");
    assertThatNullPointerException()
        .isThrownBy(() -> files.downloadAsync(null, config))
        .withMessage("name");
    assertThatNullPointerException()
        .isThrownBy(() -> files.uploadTextAsync("END", FILE, null))
        .withMessage("config");
  }

  @Test
  void theTwinsOfTransfersDoTheSame(@TempDir Path folder) throws Exception {
    Path source = java.nio.file.Files.write(folder.resolve("source"), TWO_PARTS);
    Path target = folder.resolve("target");

    files.uploadAsync(source, FILE, TransferConfig.DEFAULT).get(60, TimeUnit.SECONDS);
    files.downloadAsync(FILE, target, TransferConfig.DEFAULT).get(60, TimeUnit.SECONDS);
    assertThat(target).hasBinaryContent(TWO_PARTS);

    files
        .uploadAsync(
            new java.io.ByteArrayInputStream(TWO_PARTS),
            TWO_PARTS.length,
            OTHER,
            TransferConfig.DEFAULT)
        .get(60, TimeUnit.SECONDS);
    assertThat(tree.get(OTHER)).isEqualTo(TWO_PARTS);

    TransferConfig overwrite = TransferConfig.create(c -> c.overwrite(true));
    files.uploadTextAsync("END\r\n", OTHER, overwrite).get(60, TimeUnit.SECONDS);
    assertThat(files.downloadTextAsync(OTHER, overwrite).get(60, TimeUnit.SECONDS))
        .isEqualTo("END\r\n");
  }
}
