package no.hials.crosscom.internal.c3;

import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.Objects;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.c3.Verification;
import no.hials.crosscom.internal.Cancellation;
import no.hials.crosscom.internal.MessageChannel;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.file.FileRequest.BeginReadRequest;
import no.hials.crosscom.protocol.file.FileRequest.ContentRequest;
import no.hials.crosscom.protocol.file.FileRequest.ReadDataRequest;
import no.hials.crosscom.protocol.file.FileResponse.ContentResponse;
import no.hials.crosscom.protocol.file.FileResponse.ContentSizeResponse;
import no.hials.crosscom.protocol.file.FileResponse.ReadDataResponse;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Downloads a file, which the server reads into a buffer of the connection at the beginning
 * (docs/reference/c3-messages.md#file-content-29-and-30), so it cannot change meanwhile.
 */
final class Download extends Transfer {
  private static final Logger LOG = LoggerFactory.getLogger(Download.class);

  private final long limit;

  /**
   * Creates a download.
   *
   * @param limit the maximum size of the file in bytes
   */
  Download(
      MessageChannel channel,
      String name,
      long limit,
      TransferConfig config,
      Cancellation cancellation) {
    this(channel, "download of " + name, name, limit, config, cancellation);
  }

  private Download(
      MessageChannel channel,
      String what,
      String name,
      long limit,
      TransferConfig config,
      Cancellation cancellation) {
    super(channel, what, name, config, cancellation);
    this.limit = limit;
  }

  /** Downloads a file, and once more to compare if the configuration requires it. */
  void run(OutputStream target) throws IOException {
    fetch(target);
    if (digest != null && !Arrays.equals(digest.digest(), digest(channel, what, name, config))) {
      throw failed("the file that came a second time to compare is different");
    }
  }

  /**
   * Downloads a file only for its digest.
   *
   * @param what a noun phrase for error messages
   */
  static byte[] digest(MessageChannel channel, String what, String name, TransferConfig config)
      throws IOException {
    TransferConfig quiet =
        TransferConfig.create(
            cfg ->
                cfg.flags(config.flags().toArray(CopyFlag[]::new))
                    .verification(Verification.CONTENT));
    Download download = new Download(channel, what, name, MAX_SIZE, quiet, Cancellation.NEVER);
    download.fetch(OutputStream.nullOutputStream());
    return Objects.requireNonNull(download.digest).digest();
  }

  private void fetch(OutputStream target) throws IOException {
    MessageChannel one = channel.onOneConnection();
    try {
      ContentSizeResponse opened =
          one.ask(
              new BeginReadRequest(0, Flags.of(CopyFlag.class, config.flags()), name),
              ContentSizeResponse.class,
              what);
      check(opened, ContentOperation.BEGIN);
      long size = opened.size();
      if (size > limit) {
        throw failed("the file must have at most " + limit + " bytes, has " + size);
      }
      fetchParts(size, target, one);
      checkSize(
          one.ask(request(ContentOperation.SIZE), ContentSizeResponse.class, what),
          ContentOperation.SIZE,
          size);
    } finally {
      release(one);
    }
  }

  private static ContentRequest request(ContentOperation operation) {
    return new ContentRequest(0, MessageType.READ_CONTENT, Code.of(operation));
  }

  private void fetchParts(long size, OutputStream target, MessageChannel one) throws IOException {
    tell(size);
    while (bytes < size) {
      long most = Math.min(PART, size - bytes);
      ReadDataResponse answer =
          one.ask(new ReadDataRequest(0, bytes, most), ReadDataResponse.class, what);
      int length = answer.data().size();
      if (answer.offset() != bytes || length == 0 || length > most) {
        throw failed(
            "the server must give 1 to "
                + most
                + " bytes at "
                + bytes
                + ", gave "
                + length
                + " at "
                + answer.offset());
      }
      byte[] part = answer.data().toByteArray();
      target.write(part);
      count(part, length);
      tell(size);
    }
  }

  /** Empties the server's buffer, if the connection still exists. */
  private static void release(MessageChannel one) {
    try {
      one.ask(request(ContentOperation.END), ContentResponse.class, "end of the download");
    } catch (CrossComException e) {
      LOG.debug("the buffer of the download was not emptied: {}", e.getMessage());
    }
  }
}
