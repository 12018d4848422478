package no.hials.crosscom.internal.c3;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.UUID;

/**
 * A file of this computer that appears whole or not at all: it is written under another name in the
 * same directory, and renamed at the end.
 */
final class LocalFile implements Closeable {
  private final Path target;
  private final boolean overwrite;
  private final Path part;
  private final FileChannel channel;

  /**
   * Creates the file under another name. Of a symbolic link, the file that it points to is
   * replaced.
   *
   * @throws FileAlreadyExistsException if the target exists and may not be replaced
   * @throws FileSystemException if the target exists and is not a regular file
   */
  LocalFile(Path target, boolean overwrite) throws IOException {
    this.overwrite = overwrite;
    if (!overwrite) {
      refuseExisting(target);
    }
    this.target = overwrite && Files.exists(target) ? target.toRealPath() : target;
    refuseSpecial();
    this.part =
        this.target.resolveSibling(target.getFileName() + "." + UUID.randomUUID() + ".part");
    this.channel = FileChannel.open(part, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
  }

  /** Refuses what a rename would destroy, such as a device, a pipe or a link to nothing. */
  private void refuseSpecial() throws FileSystemException {
    if (Files.exists(target, LinkOption.NOFOLLOW_LINKS) && !Files.isRegularFile(target)) {
      throw new FileSystemException(target.toString(), null, "it is not a regular file");
    }
  }

  private static void refuseExisting(Path target) throws FileAlreadyExistsException {
    if (Files.exists(target, LinkOption.NOFOLLOW_LINKS)) {
      throw new FileAlreadyExistsException(
          target.toString(), null, "the file exists, and overwrite is false");
    }
  }

  OutputStream output() {
    return Channels.newOutputStream(channel);
  }

  /** Writes the buffers of the system to the disk. */
  void force() throws IOException {
    channel.force(true);
    channel.close();
  }

  /** Moves the file to its place. */
  void complete() throws IOException {
    if (!overwrite) {
      Files.move(part, target);
      return;
    }
    refuseSpecial();
    try {
      Files.move(part, target, StandardCopyOption.ATOMIC_MOVE);
    } catch (AtomicMoveNotSupportedException e) {
      Files.move(part, target, StandardCopyOption.REPLACE_EXISTING);
    }
  }

  /** Removes the file if it is not complete. */
  @Override
  public void close() throws IOException {
    channel.close();
    Files.deleteIfExists(part);
  }
}
