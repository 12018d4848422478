package no.hials.crosscom.cell.recording;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * A file that a recording is written to, without a buffer, so that written data survives the end of
 * this process.
 */
public final class RecordingFile implements Recording.RecordingOutput {
  private final String name;

  /**
   * Keeps others from recording to the file; not used for writing, since an interrupt would close
   * it.
   */
  private final FileChannel lock;

  private final OutputStream file;

  private RecordingFile(String name, FileChannel lock, OutputStream file) {
    this.name = name;
    this.lock = lock;
    this.file = file;
  }

  /**
   * Creates a file.
   *
   * @param name its name for messages
   * @param overwrite whether an existing file is overwritten
   * @throws OutputException if it cannot be created, or another recording writes to it
   */
  public static RecordingFile open(Path path, String name, boolean overwrite) {
    boolean replaces = overwrite || (Files.exists(path) && !Files.isRegularFile(path));
    try {
      FileChannel lock =
          FileChannel.open(
              path,
              StandardOpenOption.WRITE,
              replaces ? StandardOpenOption.CREATE : StandardOpenOption.CREATE_NEW);
      try {
        if (Files.isRegularFile(path)) {
          lock(lock);
          lock.truncate(0);
        }
        return new RecordingFile(name, lock, Files.newOutputStream(path, StandardOpenOption.WRITE));
      } catch (IOException e) {
        lock.close();
        throw e;
      }
    } catch (IOException e) {
      throw new OutputException(name, e);
    }
  }

  private static void lock(FileChannel file) throws IOException {
    boolean locked;
    try {
      // a byte after all data: on Windows, others could not read the locked bytes
      locked = file.tryLock(Long.MAX_VALUE - 1, 1, false) != null;
    } catch (OverlappingFileLockException e) {
      locked = false;
    }
    if (!locked) {
      throw new IOException("another command is recording to it");
    }
  }

  @Override
  public void write(String text) {
    try {
      file.write(text.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new OutputException(name, e);
    }
  }

  @Override
  public void close() throws IOException {
    try (lock) {
      file.close();
    }
  }
}
