package no.hials.crosscom.web.internal.http;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.zip.GZIPOutputStream;

/**
 * A file of the page.
 *
 * @param type its content type
 * @param bytes its content
 * @param zipped its content, compressed by gzip
 * @param tag names this content, for the browser's cache
 */
record PageFile(String type, byte[] bytes, byte[] zipped, String tag) {
  static PageFile of(String type, byte[] bytes) {
    return new PageFile(type, bytes, zip(bytes), '"' + hash(bytes) + '"');
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

  /** Returns the SHA-256 of some bytes in Base64, as a content security policy has it. */
  static String hash(byte[] bytes) {
    try {
      return Base64.getEncoder().encodeToString(MessageDigest.getInstance("SHA-256").digest(bytes));
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError(e); // every JVM has it
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
