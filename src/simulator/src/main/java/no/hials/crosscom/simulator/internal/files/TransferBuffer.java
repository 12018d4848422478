package no.hials.crosscom.simulator.internal.files;

import java.util.Arrays;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.file.Bytes;

/**
 * The content of one file during its transfer, in the server's memory. It reserves the announced
 * size, but allocates memory only as data arrive. Not thread-safe.
 */
public final class TransferBuffer {
  /**
   * The maximum number of bytes in one message
   * (docs/reference/c3-messages.md#file-content-29-and-30).
   */
  public static final int MAX_CHUNK = 64_512;

  private final ControllerFileSystem tree;
  private byte[] data = {};
  private int size;
  private boolean open;

  public TransferBuffer(ControllerFileSystem tree) {
    this.tree = tree;
  }

  /**
   * Empties the buffer for new content.
   *
   * @param announced the size of the file; bytes that are never written are 0 (assumed)
   * @throws FileRefusedException if too few bytes are left for transfers; the buffer is then closed
   */
  public void begin(long announced) throws FileRefusedException {
    close();
    if (!tree.takeTransfer(announced)) {
      throw new FileRefusedException(
          ErrorCode.MEMORY, "there is no room for a transfer of " + announced + " bytes");
    }
    size = (int) announced;
    open = true;
  }

  /**
   * Fills the buffer with content to read.
   *
   * @throws FileRefusedException if too few bytes are left for transfers; the buffer is then closed
   */
  public void begin(byte[] content) throws FileRefusedException {
    begin(content.length);
    data = content;
  }

  /**
   * Writes data; bytes past the announced size are cut off.
   *
   * @param offset the position of the first byte
   * @return the number of bytes written
   */
  public int write(long offset, Bytes chunk) {
    int count = available(offset, chunk.size());
    if (count > 0) {
      int end = (int) offset + count;
      if (end > data.length) {
        data = Arrays.copyOf(data, (int) Math.min(size, Math.max(end, 2L * data.length)));
      }
      System.arraycopy(chunk.toByteArray(), 0, data, (int) offset, count);
    }
    return count;
  }

  /**
   * Reads data; at the end fewer bytes than requested.
   *
   * @param offset the position of the first byte
   * @param count the maximum number of bytes to read
   */
  public Bytes read(long offset, long count) {
    int found = available(offset, Math.min(count, MAX_CHUNK));
    return Bytes.of(data, found == 0 ? 0 : (int) offset, found);
  }

  private int available(long offset, long count) {
    return (int) Math.max(0, Math.min(count, size - offset));
  }

  /**
   * Returns the announced number of bytes; the array must not be changed, and later writes may show
   * in it.
   */
  public byte[] content() {
    return data.length == size ? data : Arrays.copyOf(data, size);
  }

  /** Returns the announced size, 0 if the buffer is closed. */
  public int size() {
    return size;
  }

  public boolean isOpen() {
    return open;
  }

  /** Empties the buffer and releases its bytes. */
  public void close() {
    tree.giveBackTransfer(size);
    data = new byte[0];
    size = 0;
    open = false;
  }
}
