package no.hials.crosscom.examples;

import java.nio.file.Files;
import java.nio.file.Path;

/** Finds the programs of {@code krl}. */
final class KrlFolder {
  private KrlFolder() {}

  /**
   * Returns a file.
   *
   * @param name its name
   * @return the file, seen from the project's folder or from this module
   */
  static Path file(String name) {
    Path file = Path.of("krl", name);
    return Files.exists(file) ? file : Path.of("..", "krl", name);
  }
}
