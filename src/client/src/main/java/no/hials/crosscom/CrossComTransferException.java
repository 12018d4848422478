package no.hials.crosscom;

/**
 * Thrown if a file was not transferred, or not correctly: the target exists, or the received
 * content differs. The connection can be used.
 *
 * <p>The controller stores nothing before an upload is complete, and a failed download leaves no
 * file. If an upload is complete but the file differs, the message says so.
 */
public final class CrossComTransferException extends CrossComException {
  private static final long serialVersionUID = 1L;

  private final String file;
  private final long bytes;

  CrossComTransferException(String what, String file, long bytes, String why) {
    super("the " + what + " failed after " + bytes + " bytes: " + why, null, false);
    this.file = file;
    this.bytes = bytes;
  }

  /** Returns the file's name on the controller as it was sent. */
  public String getFile() {
    return file;
  }

  /** Returns the number of bytes transferred. */
  public long getBytes() {
    return bytes;
  }
}
