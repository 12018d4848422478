package no.hials.crosscom.control.input;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Unpacks a library to a place where no other user can put one. */
class NativeLibraryTest {
  @TempDir Path jar;

  private URL library() throws IOException {
    return Files.writeString(jar.resolve("libx.so"), "code").toUri().toURL();
  }

  @Test
  void eachTimeTheFolderIsNewAndOnlyItsOwnerCanEnterIt() throws IOException {
    assumeThat(FileSystems.getDefault().supportedFileAttributeViews()).contains("posix");

    Path first = NativeLibrary.unpack(library(), "libx.so");
    Path second = NativeLibrary.unpack(library(), "libx.so");

    assertThat(first).isAbsolute().hasContent("code").hasFileName("libx.so");
    assertThat(second.getParent()).isNotEqualTo(first.getParent());
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(first.getParent())))
        .isEqualTo("rwx------");
    for (Path file : new Path[] {first, second}) {
      Files.delete(file);
      Files.delete(file.getParent());
    }
  }

  @Test
  void anotherFileOfTheSameCrcIsRefused() {
    // two texts with the same CRC-32
    byte[] expected = "plumless".getBytes(StandardCharsets.US_ASCII);
    byte[] stored = "buckeroo".getBytes(StandardCharsets.US_ASCII);
    assertThat(crc(stored)).isEqualTo(crc(expected));

    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> NativeLibrary.check(in(expected), in(stored), Path.of("libx.so")))
        .withMessage("the SHA-256 of libx.so must be that of the library in the jar");
  }

  private static InputStream in(byte[] content) {
    return new ByteArrayInputStream(content);
  }

  private static long crc(byte[] content) {
    CRC32 crc = new CRC32();
    crc.update(content);
    return crc.getValue();
  }
}
