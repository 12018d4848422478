package no.hials.crosscom.cli.base;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.RemoteName;
import no.hials.crosscom.cell.recording.OutputException;
import org.jspecify.annotations.Nullable;

/** The files of this computer that commands read and write. */
public final class LocalFiles {
  private LocalFiles() {}

  /** Converts an argument to a path; reports wrong usage if it is not one. */
  public static Path path(ConsoleCommand command, String text) {
    try {
      if (!text.isBlank()) {
        return Path.of(text);
      }
    } catch (InvalidPathException e) {
      // reported below
    }
    throw command.wrongUsage("'" + text + "' cannot be a file's name here");
  }

  /** Returns whether the text of a path ends like a folder, which {@link Path} does not keep. */
  public static boolean endsLikeFolder(String text) {
    return text.endsWith("/") || text.endsWith(File.separator);
  }

  public static String name(Path file) {
    return String.valueOf(file.getFileName());
  }

  /** Refuses a file that cannot be uploaded, before any upload. */
  public static void checkReadable(Path file) throws FileException {
    if (!Files.exists(file)) {
      throw FileException.cannot("read", file, new NoSuchFileException(file.toString()));
    }
    if (!Files.isRegularFile(file) || !Files.isReadable(file)) {
      String reason = Files.isDirectory(file) ? "it is a folder" : "access is denied";
      throw FileException.cannot("read", file, new IOException(reason));
    }
  }

  /**
   * Refuses a file in a folder that does not exist.
   *
   * @throws OutputException if so
   */
  public static void checkFolderOf(Path file) {
    Path folder = file.toAbsolutePath().getParent();
    if (folder == null || !Files.isDirectory(folder)) {
      throw new OutputException(file.toString(), new IOException("there is no folder " + folder));
    }
  }

  /**
   * Refuses a file that already exists or cannot be created.
   *
   * @param overwrite whether to replace an existing file
   * @throws FileException if it exists
   * @throws OutputException if it cannot be created
   */
  public static void checkNew(Path file, boolean overwrite) throws FileException {
    checkFolderOf(file);
    if (Files.isDirectory(file)) {
      throw new OutputException(file.toString(), new IOException("it is a folder"));
    }
    // not a device or a pipe, which has nothing to lose
    if (Files.isRegularFile(file) && !overwrite) {
      throw new FileException(file + " already exists; --yes overwrites it");
    }
  }

  /**
   * Finds the data list next to a program, in any case of its name; null without one.
   *
   * @throws FileException if the folder cannot be listed, or if several files match and none has
   *     the case of the program
   */
  public static @Nullable Path dataListOf(Path program) throws FileException {
    Path folder = program.toAbsolutePath().getParent();
    if (folder == null) {
      return null;
    }
    String wanted = RemoteName.dataListOf(name(program));
    try (Stream<Path> files = Files.list(folder)) {
      List<String> found =
          files.map(LocalFiles::name).filter(wanted::equalsIgnoreCase).sorted().toList();
      if (found.size() > 1 && !found.contains(wanted)) {
        throw new FileException(
            program + " has several data lists: " + String.join(", ", found) + "; rename one");
      }
      return found.isEmpty()
          ? null
          : program.resolveSibling(found.contains(wanted) ? wanted : found.get(0));
    } catch (FileException e) {
      throw e;
    } catch (IOException e) {
      throw FileException.cannot("list", folder, e);
    }
  }
}
