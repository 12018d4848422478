package no.hials.crosscom.gateway.internal.sparkplug;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The number of a connection, {@code bdSeq}, which tells its will from the wills of other
 * connections. It is kept in a file. Not thread-safe.
 */
final class BirthNumber {
  private static final Logger LOG = LoggerFactory.getLogger(BirthNumber.class);
  private static final int NUMBERS = 256;

  private final Path file;
  private int current;

  BirthNumber(Path file) {
    this.file = file;
    int last = -1;
    try {
      if (Files.exists(file)) {
        last = Integer.parseInt(Files.readString(file).strip());
      }
    } catch (IOException | NumberFormatException e) {
      LOG.warn("cannot read the number of the last connection in {}: {}", file, e.toString());
    }
    current = Math.floorMod(last, NUMBERS);
  }

  /** Returns the number of this connection. */
  int current() {
    return current;
  }

  /** Increments the number for the next connection. */
  void next() {
    current = (current + 1) % NUMBERS;
    try {
      Files.createDirectories(file.toAbsolutePath().getParent());
      Files.writeString(file, current + "\n");
    } catch (IOException e) {
      LOG.warn("cannot write {}: {}", file, e.toString());
    }
  }
}
