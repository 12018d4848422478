package no.hials.crosscom.cli.base;

import java.nio.file.Files;
import java.nio.file.Path;
import no.hials.crosscom.cell.FileException;

/** Keeps commands from writing over what is there. */
public final class NewFile {
  private NewFile() {}

  /**
   * Refuses a file that is there already, or cannot be.
   *
   * @param overwrite whether the user wants it written over
   */
  public static void check(Path file, boolean overwrite) throws FileException {
    LocalFiles.checkFolderOf(file);
    if (Files.isDirectory(file)) {
      throw new FileException("cannot write " + file + ": it is a folder");
    }
    // not a device or a pipe, which has nothing to lose
    if (Files.isRegularFile(file) && !overwrite) {
      throw new FileException("there is a file " + file + " already; --yes overwrites it");
    }
  }
}
