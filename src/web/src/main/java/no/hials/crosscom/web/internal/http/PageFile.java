package no.hials.crosscom.web.internal.http;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.zip.GZIPOutputStream;

/** A file of the page, plain and compressed. */
final class PageFile {
  private final String type;
  private final byte[] bytes;
  private final byte[] zipped;
  private final String tag;

  /**
   * Creates a file.
   *
   * @param type its content type
   * @param bytes its content
   */
  PageFile(String type, byte[] bytes) {
    this.type = type;
    this.bytes = bytes;
    zipped = zip(bytes);
    tag = '"' + hash(bytes) + '"';
  }

  /** Returns the content type. */
  String type() {
    return type;
  }

  /** Returns the content, compressed by gzip or not. */
  ByteBuffer content(boolean compressed) {
    return ByteBuffer.wrap(compressed ? zipped : bytes);
  }

  /** Returns the ETag of this content, for the cache of browsers. */
  String tag() {
    return tag;
  }

  /** Returns a resource of the class path. */
  static byte[] resource(String path) throws IOException {
    try (InputStream in = PageFile.class.getResourceAsStream(path)) {
      if (in == null) {
        throw new IOException(path + " is not on the class path");
      }
      return in.readAllBytes();
    }
  }

  /** Returns the SHA-256 of some bytes in Base64, as content security policies write it. */
  static String hash(byte[] bytes) {
    try {
      return Base64.getEncoder().encodeToString(MessageDigest.getInstance("SHA-256").digest(bytes));
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError(e); // every JVM has SHA-256
    }
  }

  private static byte[] zip(byte[] bytes) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (GZIPOutputStream gzip = new GZIPOutputStream(out)) {
      gzip.write(bytes);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return out.toByteArray();
  }
}
