package no.hials.crosscom.internal.c3;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.util.concurrent.locks.ReentrantLock;
import no.hials.crosscom.CrossComTransferException;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.internal.Cancellation;
import no.hials.crosscom.internal.MessageChannel;

/**
 * Transfers the files of a client, one after the other: the server keeps one upload and one
 * download per connection, and would mix the parts of two.
 */
final class Transfers {
  /** The maximum size of a file in memory, even if a server reports more. */
  static final int MAX_IN_MEMORY = 64 << 20;

  private final MessageChannel channel;

  /** Held for a whole transfer; guards only the state of transfers. */
  private final ReentrantLock turn = new ReentrantLock(true);

  Transfers(MessageChannel channel) {
    this.channel = channel;
  }

  void upload(byte[] content, String name, TransferConfig config, Cancellation cancellation)
      throws IOException {
    upload(new ByteArrayInputStream(content), content.length, name, config, cancellation);
  }

  void upload(Path source, String name, TransferConfig config, Cancellation cancellation)
      throws IOException {
    try (FileChannel channel = FileChannel.open(source)) {
      upload(Channels.newInputStream(channel), channel.size(), name, config, cancellation);
    }
  }

  void upload(
      InputStream content, long size, String name, TransferConfig config, Cancellation cancellation)
      throws IOException {
    Upload upload = new Upload(channel, name, size, config, cancellation);
    begin(upload);
    try {
      upload.run(content);
    } finally {
      turn.unlock();
    }
  }

  byte[] download(String name, TransferConfig config, Cancellation cancellation)
      throws IOException {
    Download download = new Download(channel, name, MAX_IN_MEMORY, config, cancellation);
    begin(download);
    try {
      ByteArrayOutputStream target = new ByteArrayOutputStream();
      download.run(target);
      cancellation.commit();
      return target.toByteArray();
    } finally {
      turn.unlock();
    }
  }

  void download(String name, Path target, TransferConfig config, Cancellation cancellation)
      throws IOException {
    Download download = new Download(channel, name, Transfer.MAX_SIZE, config, cancellation);
    begin(download);
    try (LocalFile file = new LocalFile(target, config.overwrite())) {
      download.run(file.output());
      file.force();
      cancellation.commit();
      file.complete();
    } finally {
      turn.unlock();
    }
  }

  private void begin(Transfer transfer) throws CrossComTransferException {
    if (turn.isHeldByCurrentThread()) {
      throw new IllegalStateException(
          "the " + transfer.what + " cannot begin while the same thread does another transfer");
    }
    try {
      turn.lockInterruptibly();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw transfer.failed("the thread was interrupted before its turn came");
    }
  }
}
