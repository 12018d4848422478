package no.hials.crosscom.gateway.internal.broker;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps a second gateway out of a folder: each would forward and delete the messages of the other.
 */
public final class FolderLock implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(FolderLock.class);

  private final @Nullable FileChannel file;

  private FolderLock(@Nullable FileChannel file) {
    this.file = file;
  }

  /**
   * Locks a folder until {@link #close} or the end of the process.
   *
   * @throws IOException if another gateway has locked it
   */
  public static FolderLock of(Path folder) throws IOException {
    FileChannel file;
    try {
      Files.createDirectories(folder);
      file =
          FileChannel.open(
              folder.resolve("lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
    } catch (IOException e) {
      // values are published even if the disk is full
      LOG.warn("cannot lock {}: {}", folder, e.toString());
      return new FolderLock(null);
    }
    if (!isLocked(file)) {
      file.close();
      throw new IOException(
          "[mqtt] another gateway uses "
              + folder
              + ": give each gateway a folder of its own with --data");
    }
    return new FolderLock(file);
  }

  private static boolean isLocked(FileChannel file) throws IOException {
    try {
      return file.tryLock() != null;
    } catch (OverlappingFileLockException e) {
      return false;
    }
  }

  @Override
  public void close() {
    try {
      if (file != null) {
        file.close();
      }
    } catch (IOException e) {
      LOG.warn("cannot unlock: {}", e.toString());
    }
  }
}
