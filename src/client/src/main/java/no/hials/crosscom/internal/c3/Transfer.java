package no.hials.crosscom.internal.c3;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import no.hials.crosscom.CrossComTransferException;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.c3.Verification;
import no.hials.crosscom.internal.Cancellation;
import no.hials.crosscom.internal.MessageChannel;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.file.FileResponse.ContentSizeResponse;
import org.jspecify.annotations.Nullable;

/** The common parts of an upload and a download: progress and failure. */
abstract class Transfer {
  /** The maximum bytes per message (docs/reference/c3-messages.md#file-content-29-and-30). */
  static final int PART = 64_512;

  /**
   * The maximum file size; sizes and offsets are u32
   * (docs/reference/c3-messages.md#file-content-29-and-30).
   */
  static final long MAX_SIZE = 0xFFFF_FFFFL;

  final MessageChannel channel;
  final String what;
  final String name;
  final TransferConfig config;
  final Cancellation cancellation;
  final @Nullable MessageDigest digest;

  /** The number of bytes transferred. */
  long bytes;

  Transfer(
      MessageChannel channel,
      String what,
      String name,
      TransferConfig config,
      Cancellation cancellation) {
    this.channel = channel;
    this.what = what;
    this.name = name;
    this.config = config;
    this.cancellation = cancellation;
    this.digest = config.verification() == Verification.CONTENT ? newDigest() : null;
  }

  private static MessageDigest newDigest() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError("every Java platform has SHA-256", e);
    }
  }

  /** Reports the progress, unless the transfer was cancelled. No lock of the client is held. */
  final void tell(long total) {
    cancellation.check();
    config.progress().transferred(bytes, total);
    cancellation.check();
  }

  /** Adds a part to the count and the digest. */
  final void count(byte[] part, int length) {
    if (digest != null) {
      digest.update(part, 0, length);
    }
    bytes += length;
  }

  /** Checks the size of the server's buffer. */
  final void checkSize(ContentSizeResponse answer, ContentOperation operation, long expected)
      throws CrossComTransferException {
    check(answer, operation);
    if (answer.size() != expected) {
      throw failed("the server's buffer must have " + expected + " bytes, has " + answer.size());
    }
  }

  final void check(ContentSizeResponse answer, ContentOperation operation)
      throws CrossComTransferException {
    if (answer.operation() != operation) {
      throw failed("the server must answer " + operation + ", answers " + answer.operation());
    }
  }

  final CrossComTransferException failed(String why) {
    return channel.transferFailed(what, name, bytes, why);
  }
}
