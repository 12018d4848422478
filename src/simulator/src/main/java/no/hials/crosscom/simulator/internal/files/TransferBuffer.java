package no.hials.crosscom.simulator.internal.files;

import java.util.Arrays;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.file.Bytes;

/**
 * A buffer for the content of one file on its way, in the server's memory. It takes the announced
 * size from what the tree has for transfers, but memory only as data come. Not thread-safe.
 */
public final class TransferBuffer {
  /** The most that one message brings (docs/reference/c3-messages.md#file-content-29-and-30). */
  public static final int MAX_CHUNK = 64_512;

  private final ControllerFileSystem tree;
  private byte[] data = {};
  private int size;
  private boolean open;

  /**
   * Makes an empty buffer.
   *
   * @param tree whose room it takes
   */
  public TransferBuffer(ControllerFileSystem tree) {
    this.tree = tree;
  }

  /**
   * Begins anew, empty.
   *
   * @param announced the size of the file; what is never written is 0, which is assumed
   * @throws FileRefusedException if there is not so much room; the buffer is closed then
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
   * Begins anew with a content to be read.
   *
   * @param content all of it
   * @throws FileRefusedException if there is not so much room; the buffer is closed then
   */
  public void begin(byte[] content) throws FileRefusedException {
    begin(content.length);
    data = content;
  }

  /**
   * Takes data; those past the announced size are cut off
   * (docs/reference/c3-messages.md#file-content-29-and-30).
   *
   * @param offset where they begin
   * @param chunk the data
   * @return how many were taken
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
   * Gives data; fewer than asked for if there are no more (c3-vectors.tsv, type 30).
   *
   * @param offset where they begin
   * @param count how many at most
   * @return the data
   */
  public Bytes read(long offset, long count) {
    int found = available(offset, Math.min(count, MAX_CHUNK));
    return Bytes.of(data, found == 0 ? 0 : (int) offset, found);
  }

  private int available(long offset, long count) {
    return (int) Math.max(0, Math.min(count, size - offset));
  }

  /**
   * Gives all of it.
   *
   * @return as many bytes as were announced; not to be changed, and what is written next may or may
   *     not show in it
   */
  public byte[] content() {
    return data.length == size ? data : Arrays.copyOf(data, size);
  }

  /**
   * Gives the size.
   *
   * @return what was announced, 0 if nothing was
   */
  public int size() {
    return size;
  }

  /**
   * Says whether it has begun.
   *
   * @return true until it is closed
   */
  public boolean isOpen() {
    return open;
  }

  /** Ends it and gives the room back. */
  public void close() {
    tree.giveBackTransfer(size);
    data = new byte[0];
    size = 0;
    open = false;
  }
}
