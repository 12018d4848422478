package no.hials.crosscom.c3;

/** Listens to the progress of an upload or a download. */
@FunctionalInterface
public interface TransferProgress {
  /**
   * Called at the beginning and after each part, in the thread that transfers, between two
   * exchanges. It can use the client, but must not wait for another transfer of the same client,
   * which would wait for this transfer. An exception ends the transfer.
   *
   * @param bytes number of bytes transferred
   * @param total number of bytes of the file
   */
  void transferred(long bytes, long total);
}
