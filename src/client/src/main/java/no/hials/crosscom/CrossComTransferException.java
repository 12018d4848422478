package no.hials.crosscom;

/**
 * Says that a file was not transferred, or not as it is: the target is there already, or what
 * arrived is not what was sent. The connection can be used.
 *
 * <p>Before an upload is complete, the controller has nothing of the file; a download that failed
 * leaves no file. Where an upload is complete but the file differs, the message says so.
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

  /**
   * Gives the file on the controller.
   *
   * @return its name as it was sent
   */
  public String getFile() {
    return file;
  }

  /**
   * Says how far the transfer had come.
   *
   * @return how many bytes were transferred
   */
  public long getBytes() {
    return bytes;
  }
}
