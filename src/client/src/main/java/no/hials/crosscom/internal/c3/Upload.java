package no.hials.crosscom.internal.c3;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.EnumSet;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComTransferException;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.c3.Verification;
import no.hials.crosscom.internal.Cancellation;
import no.hials.crosscom.internal.MessageChannel;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.FileProperty;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.file.Bytes;
import no.hials.crosscom.protocol.file.FileRequest.BeginWriteRequest;
import no.hials.crosscom.protocol.file.FileRequest.ContentRequest;
import no.hials.crosscom.protocol.file.FileRequest.EndWriteRequest;
import no.hials.crosscom.protocol.file.FileRequest.FilePropertiesRequest;
import no.hials.crosscom.protocol.file.FileRequest.WriteDataRequest;
import no.hials.crosscom.protocol.file.FileResponse.ContentResponse;
import no.hials.crosscom.protocol.file.FileResponse.ContentSizeResponse;
import no.hials.crosscom.protocol.file.FileResponse.FilePropertiesResponse;
import no.hials.crosscom.protocol.file.FileResponse.WriteDataResponse;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Uploads a file. The server collects the content in a buffer of the connection and creates the
 * file at the end (docs/reference/c3-messages.md#file-content-29-and-30).
 */
final class Upload extends Transfer {
  private static final Logger LOG = LoggerFactory.getLogger(Upload.class);

  /** Names the upload from its last message on, with which the server stores the file. */
  private final String upload;

  private final long size;

  Upload(
      MessageChannel channel,
      String name,
      long size,
      TransferConfig config,
      Cancellation cancellation) {
    super(channel, "upload of " + name + " (nothing was stored)", name, config, cancellation);
    this.upload = "upload of " + name;
    this.size = size;
  }

  void run(InputStream content) throws IOException {
    if (size > MAX_SIZE) {
      throw failed("a file must have at most " + MAX_SIZE + " bytes, has " + size);
    }
    // first, because otherwise the error would name the properties and not the upload
    channel.require(MessageType.WRITE_CONTENT, upload);
    if (!config.overwrite() && C3Files.exists(channel, name, what)) {
      throw failed("the file exists on the controller, and overwrite is false");
    }
    store(content);
    verify();
  }

  private void store(InputStream content) throws IOException {
    // on another connection the buffer would be empty, and its end would store an empty file
    MessageChannel one = channel.onOneConnection();
    boolean stored = false;
    try {
      checkSize(
          one.ask(new BeginWriteRequest(0, size), ContentSizeResponse.class, what),
          ContentOperation.BEGIN,
          size);
      sendParts(content, one);
      checkSize(
          one.ask(sizeRequest(), ContentSizeResponse.class, what), ContentOperation.SIZE, size);
      cancellation.commit();
      one.ask(new EndWriteRequest(0, flags(), name), ContentResponse.class, upload);
      stored = true;
    } finally {
      if (!stored) {
        release(one);
      }
    }
  }

  private static ContentRequest sizeRequest() {
    return new ContentRequest(0, MessageType.WRITE_CONTENT, Code.of(ContentOperation.SIZE));
  }

  private Flags<CopyFlag> flags() {
    EnumSet<CopyFlag> flags = EnumSet.noneOf(CopyFlag.class);
    flags.addAll(config.flags());
    if (config.overwrite()) {
      flags.add(CopyFlag.OVERWRITE);
    }
    return Flags.of(CopyFlag.class, flags);
  }

  private void sendParts(InputStream content, MessageChannel one) throws IOException {
    byte[] part = new byte[(int) Math.min(PART, size)];
    tell(size);
    while (bytes < size) {
      int length = content.readNBytes(part, 0, (int) Math.min(part.length, size - bytes));
      if (length == 0) {
        throw failed("the content must have " + size + " bytes, has " + bytes);
      }
      sendPart(part, length, one);
      tell(size);
    }
    if (content.read() >= 0) {
      throw failed("the content must have " + size + " bytes, has more");
    }
  }

  private void sendPart(byte[] part, int length, MessageChannel one) throws CrossComException {
    WriteDataResponse answer =
        one.ask(
            new WriteDataRequest(0, bytes, Bytes.of(part, 0, length)),
            WriteDataResponse.class,
            what);
    if (answer.offset() != bytes || answer.written() != length) {
      throw failed(
          "the server must take "
              + length
              + " bytes at "
              + bytes
              + ", took "
              + answer.written()
              + " at "
              + answer.offset());
    }
    count(part, length);
  }

  /** Empties the server's buffer, if the connection still exists. */
  private static void release(MessageChannel one) {
    try {
      one.ask(new BeginWriteRequest(0, 0), ContentSizeResponse.class, "end of the upload");
    } catch (CrossComException e) {
      LOG.debug("the buffer of the failed upload was not emptied: {}", e.getMessage());
    }
  }

  private void verify() throws IOException {
    if (config.verification() == Verification.PARTS) {
      return;
    }
    String check = "verification of " + name + " (the file is stored but was not verified)";
    long stored =
        channel
            .ask(
                new FilePropertiesRequest(0, Flags.of(FileProperty.SIZE), name),
                FilePropertiesResponse.class,
                check)
            .properties()
            .size();
    if (stored != size) {
      throw wronglyStored("has " + stored + " bytes instead of " + size);
    }
    if (digest != null
        && !Arrays.equals(digest.digest(), Download.digest(channel, check, name, config))) {
      throw wronglyStored("its content differs from the content sent");
    }
  }

  private CrossComTransferException wronglyStored(String why) {
    return channel.transferFailed(upload, name, bytes, "the file is stored, but " + why);
  }
}
