package no.hials.crosscom.c3;

/** Hears how far an upload or a download has come. */
@FunctionalInterface
public interface TransferProgress {
  /**
   * Takes the news: once at the beginning, and after each part. It is called by the thread that
   * transfers, between two exchanges, when others may use the client; but it must not wait for
   * another transfer of the same client, as that waits for this one. What it throws ends the
   * transfer.
   *
   * @param bytes how many are transferred
   * @param total how many there are
   */
  void transferred(long bytes, long total);
}
