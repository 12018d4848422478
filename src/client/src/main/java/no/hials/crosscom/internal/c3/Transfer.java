package no.hials.crosscom.internal.c3;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import no.hials.crosscom.CrossComTransferException;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.c3.Verification;
import no.hials.crosscom.internal.Cancellation;
import no.hials.crosscom.internal.MessageChannel;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.file.ContentSizeResponse;
import org.jspecify.annotations.Nullable;

/** What an upload and a download have in common: how far they are, and how they fail. */
abstract class Transfer {
  /** The most bytes that a message moves (docs/reference/c3-messages.md#file-content-29-and-30). */
  static final int PART = 64_512;

  /**
   * The most bytes that a file can have, since sizes and offsets are u32
   * (docs/reference/c3-messages.md#file-content-29-and-30).
   */
  static final long MAX_SIZE = 0xFFFF_FFFFL;

  final MessageChannel channel;
  final String what;
  final String name;
  final TransferConfig config;
  final Cancellation cancellation;
  final @Nullable MessageDigest digest;

  /** How many bytes are transferred. */
  long bytes;

  Transfer(
      MessageChannel channel,
      String what,
      String name,
      TransferConfig config,
      Cancellation cancellation) {
    this.channel = channel;
    this.what = what + " of " + name;
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

  /** Tells how far it has come, unless it was cancelled. No lock of the client is held. */
  final void tell(long total) {
    cancellation.check();
    config.progress().transferred(bytes, total);
    cancellation.check();
  }

  /** Takes a part into account. */
  final void count(byte[] part, int length) {
    if (digest != null) {
      digest.update(part, 0, length);
    }
    bytes += length;
  }

  /** Checks what the server says about the size of its buffer. */
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
