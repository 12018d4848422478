package no.hials.crosscom.internal.exchange;

import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;

/** Recognises a service of another protocol by the first bytes that it sends. */
public final class ForeignService {
  /** No frame begins with as many letters: the fifth byte is its function, the sixth a length. */
  private static final int MIN_TEXT = 8;

  private static final int MAX_TEXT = 60;

  /** The first byte of a TLS alert and of a TLS handshake; the next one is 3 (RFC 8446, 5.1). */
  private static final int TLS_ALERT = 0x15;

  private static final int TLS_HANDSHAKE = 0x16;

  private ForeignService() {}

  /**
   * Returns the protocol of a service, and the first line that it sent, if that is a text.
   *
   * @param bytes a buffer that begins with the bytes
   * @param length the number of bytes
   * @return a phrase; null if the bytes are not those of a known protocol
   */
  public static @Nullable String of(byte[] bytes, int length) {
    String line = firstLine(bytes, length);
    if (line.length() < MIN_TEXT) {
      boolean tls = length > 4 && (bytes[0] == TLS_ALERT || bytes[0] == TLS_HANDSHAKE);
      return tls && bytes[1] == 3 && bytes[2] <= 4 ? "TLS" : null;
    }
    if (line.startsWith("HTTP/") || line.startsWith("<")) {
      return "HTTP (" + line + ")";
    }
    return line.startsWith("SSH-") ? "SSH (" + line + ")" : "a text (" + line + ")";
  }

  /** Returns the printable ASCII characters at the beginning. */
  private static String firstLine(byte[] bytes, int length) {
    int end = 0;
    while (end < Math.min(length, MAX_TEXT) && bytes[end] >= ' ' && bytes[end] < 0x7F) {
      end++;
    }
    return new String(bytes, 0, end, StandardCharsets.US_ASCII);
  }
}
