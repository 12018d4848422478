package no.hials.crosscom.simulator.internal.files;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.UUID;
import no.hials.crosscom.protocol.code.FileAttribute;
import org.jspecify.annotations.Nullable;

/**
 * Stores items in a folder of this machine, and never leaves it. Links are refused, not followed.
 * Devices and names that {@link ControllerPath} does not allow are hidden. The attributes are kept
 * in memory, because most file systems do not have those of Windows.
 *
 * <p>Another program that changes the folder at the same time could make it leave the folder; a
 * client of the server cannot.
 */
final class FolderStore implements ItemStore {
  private final Path root;
  private final long maxFile;

  /** The attributes that were set, by the full name in capital letters. */
  private final Map<String, Integer> attributes = new HashMap<>();

  /**
   * Opens a folder.
   *
   * @param maxFile the size of the largest file that can be read, in bytes
   * @throws IOException if it is not a folder
   */
  FolderStore(Path root, long maxFile) throws IOException {
    this.root = root.toRealPath();
    this.maxFile = maxFile;
  }

  @Override
  public @Nullable FileItem find(ControllerPath path) throws IOException {
    FileItem item = item(ControllerPath.ROOT, root);
    for (String name : path.names()) {
      item = item == null || !item.directory() ? null : entries(item.path()).get(name);
    }
    if (item == null && !path.isRoot()) {
      refuseLink(path);
    }
    return item;
  }

  /** Refuses the name of a link or of another entry that is hidden. */
  private void refuseLink(ControllerPath path) throws IOException {
    Path folder = root;
    for (String name : path.names()) {
      Path found = null;
      if (Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder)) {
          for (Path file : files) {
            found = fileName(file).equalsIgnoreCase(name) ? file : found;
          }
        }
      }
      if (found == null) {
        return;
      }
      if (!isPlain(attributes(found))) {
        throw FileRefusedException.access(path, "is a link, or not a file");
      }
      folder = found;
    }
  }

  private static String fileName(Path file) {
    return Objects.requireNonNull(file.getFileName(), "an entry of a folder has a name").toString();
  }

  private static BasicFileAttributes attributes(Path file) throws IOException {
    return Files.readAttributes(file, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
  }

  /** Returns false for devices and links; a link of Windows can look like a folder. */
  private static boolean isPlain(BasicFileAttributes found) {
    return (found.isDirectory() || found.isRegularFile())
        && !found.isSymbolicLink()
        && !found.isOther();
  }

  private Path file(ControllerPath path) throws FileRefusedException {
    try {
      Path file = root;
      for (String name : path.names()) {
        file = file.resolve(name);
      }
      return file;
    } catch (InvalidPathException e) {
      throw FileRefusedException.argument("not a valid name on this machine: " + path);
    }
  }

  /** If names differ only in case, the first is used. */
  private Map<String, FileItem> entries(ControllerPath folder) throws IOException {
    Map<String, FileItem> items = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
    List<Path> sorted = new ArrayList<>();
    try (DirectoryStream<Path> files = Files.newDirectoryStream(file(folder))) {
      files.forEach(sorted::add);
    }
    sorted.sort(null);
    for (Path file : sorted) {
      String name = fileName(file);
      FileItem item = ControllerPath.isSafe(name) ? item(folder.known(name), file) : null;
      if (item != null) {
        items.putIfAbsent(name, item);
      }
    }
    return items;
  }

  private @Nullable FileItem item(ControllerPath path, Path file) throws IOException {
    BasicFileAttributes found = attributes(file);
    if (!isPlain(found)) {
      return null;
    }
    int kind = (found.isDirectory() ? FileAttribute.DIRECTORY : FileAttribute.ARCHIVE).code();
    return new FileItem(
        path,
        found.isDirectory(),
        found.isDirectory() ? 0 : found.size(),
        attributes.getOrDefault(key(path), kind),
        found.creationTime().toInstant(),
        found.lastAccessTime().toInstant(),
        found.lastModifiedTime().toInstant());
  }

  private static String key(ControllerPath path) {
    return ControllerPath.upper(path.fullName());
  }

  @Override
  public List<FileItem> children(ControllerPath folder) throws IOException {
    return List.copyOf(entries(folder).values());
  }

  @Override
  public byte[] read(FileItem file) throws IOException {
    int limit = (int) Math.min(maxFile, Integer.MAX_VALUE - 64);
    try (var in =
        Files.newInputStream(
            file(file.path()), StandardOpenOption.READ, LinkOption.NOFOLLOW_LINKS)) {
      byte[] content = in.readNBytes(limit);
      if (in.read() >= 0) {
        throw CheckedWriter.tooLarge(file.path(), limit);
      }
      return content;
    }
  }

  @Override
  public void write(ControllerPath path, byte[] content) throws IOException {
    Path target = file(path);
    if (Files.exists(target, LinkOption.NOFOLLOW_LINKS) && !Files.isWritable(target)) {
      throw new AccessDeniedException(target.toString());
    }
    // first a temporary file next to it, so that a full disk leaves the old file and no half of the
    // new one
    Path part = target.resolveSibling(UUID.randomUUID() + ".part");
    try {
      Files.write(part, content, StandardOpenOption.CREATE_NEW);
      Files.move(part, target, StandardCopyOption.REPLACE_EXISTING);
    } finally {
      Files.deleteIfExists(part);
    }
    attributes.computeIfPresent(key(path), (k, bits) -> bits | FileAttribute.ARCHIVE.code());
  }

  @Override
  public void makeFolder(ControllerPath path) throws IOException {
    Files.createDirectory(file(path));
  }

  @Override
  public void delete(FileItem item) throws IOException {
    Files.delete(file(item.path()));
    attributes.remove(key(item.path()));
  }

  @Override
  public void move(FileItem item, ControllerPath to) throws IOException {
    Files.move(file(item.path()), file(to));
    String from = key(item.path());
    Map<String, Integer> moved = new HashMap<>();
    attributes
        .entrySet()
        .removeIf(
            entry -> {
              String name = entry.getKey();
              boolean inside = name.equals(from) || name.startsWith(from + "\\");
              if (inside) {
                moved.put(key(to) + name.substring(from.length()), entry.getValue());
              }
              return inside;
            });
    attributes.putAll(moved);
  }

  @Override
  public void setAttributes(FileItem item, int bits) {
    attributes.put(key(item.path()), bits);
  }

  @Override
  public long used() throws IOException {
    long[] used = {0};
    Files.walkFileTree(
        root,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes found) {
            used[0] += found.size() + ITEM_COST;
            return FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult postVisitDirectory(Path folder, @Nullable IOException e) {
            used[0] += ITEM_COST;
            return FileVisitResult.CONTINUE;
          }
        });
    return used[0];
  }
}
