package no.hials.crosscom.control.input;

import java.io.File;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;

/**
 * Loads a native library from the class path. Each time it is unpacked into a new folder that only
 * its owner can read and write, so no file of another user is loaded.
 */
final class NativeLibrary {
  private static final String FOLDER = "jopenshowvar";

  private NativeLibrary() {}

  /**
   * Loads a library.
   *
   * @param owner a class of the jar with the library
   * @param name the name of the file, at the root of the jar
   * @throws IOException if it cannot be unpacked
   * @throws UnsatisfiedLinkError if it cannot be loaded
   */
  static void load(Class<?> owner, String name) throws IOException {
    URL library = owner.getResource("/" + name);
    if (library == null) {
      throw new FileNotFoundException("the class path has no " + name);
    }
    Path file = unpack(library, name);
    try {
      System.load(file.toString());
    } finally {
      remove(file);
    }
  }

  /** Unpacks a library into a new private folder, and checks what is stored there. */
  static Path unpack(URL library, String name) throws IOException {
    boolean posix = FileSystems.getDefault().supportedFileAttributeViews().contains("posix");
    // elsewhere the rights are those of the temporary folder, which Windows has for each user
    FileAttribute<?>[] rights =
        posix
            ? new FileAttribute<?>[] {
              PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------"))
            }
            : new FileAttribute<?>[0];
    Path file = Files.createTempDirectory(FOLDER, rights).toAbsolutePath().resolve(name);
    try (InputStream content = library.openStream()) {
      Files.copy(content, file);
    }
    try (InputStream expected = library.openStream();
        InputStream stored = Files.newInputStream(file)) {
      check(expected, stored, file);
    } catch (IOException e) {
      remove(file);
      throw e;
    }
    return file;
  }

  /** Checks that an unpacked library has the content of the jar. */
  static void check(InputStream expected, InputStream stored, Path file) throws IOException {
    if (!MessageDigest.isEqual(digest(expected), digest(stored))) {
      throw new IOException("the SHA-256 of " + file + " must be that of the library in the jar");
    }
  }

  private static byte[] digest(InputStream content) throws IOException {
    try {
      return MessageDigest.getInstance("SHA-256").digest(content.readAllBytes());
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError("every JDK has SHA-256", e);
    }
  }

  /** Deletes the file and its folder. Windows refuses it while the library is in use. */
  private static void remove(Path file) {
    File folder = file.toFile().getParentFile();
    if (!file.toFile().delete() || !folder.delete()) {
      folder.deleteOnExit(); // in the reverse order
      file.toFile().deleteOnExit();
    }
  }
}
