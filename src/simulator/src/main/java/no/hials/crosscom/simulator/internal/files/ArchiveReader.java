package no.hials.crosscom.simulator.internal.files;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Enumeration;
import java.util.List;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;
import no.hials.crosscom.protocol.value.PrintableText;
import org.jspecify.annotations.Nullable;

/**
 * Reads the files of an archive from zips, folders and single files. It reads at most {@link
 * #MAX_TOTAL} bytes in all, so that a zip cannot fill the memory, programs and data lists first.
 */
public final class ArchiveReader {
  private static final String UNSUPPORTED =
      "the zip has a compression method that is not supported; stored and deflated are";

  /** The largest file that is read: 32 MiB. */
  static final int MAX_FILE = 32 << 20;

  /** The bytes that are read from an archive: 128 MiB; assumed. */
  static final long MAX_TOTAL = 128L << 20;

  private static final int MAX_FILES = 20_000;

  /** Of names without the flag for UTF-8; not in every Java runtime. */
  private static final String ZIP_NAMES = "IBM437";

  private static final byte[] NOTHING = {};

  private long left = MAX_TOTAL;

  private ArchiveReader() {}

  /** Opens the content of a file. */
  @FunctionalInterface
  private interface Opener {
    InputStream open() throws IOException;
  }

  /**
   * @param checksum that of a file in a zip; null without one
   */
  private record Source(String path, Opener opener, @Nullable Long checksum) {}

  /**
   * Reads an archive. Folders and files whose names begin with a dot are left out, and links.
   *
   * @param places zips, folders and single files
   * @return the files of each place, those that were refused too
   * @throws IOException if it cannot be read, has too many files, or has no program and no data
   *     list
   */
  public static List<List<ArchivedFile>> read(List<Path> places) throws IOException {
    ArchiveReader reader = new ArchiveReader();
    List<List<ArchivedFile>> files = new ArrayList<>();
    for (Path place : places) {
      files.add(reader.read(place));
    }
    if (files.stream().flatMap(List::stream).noneMatch(ArchivedFile::isModule)) {
      throw problem(places.get(0), "there is no .src, .sub or .dat file in it");
    }
    return files;
  }

  private List<ArchivedFile> read(Path place) throws IOException {
    if (!Files.exists(place)) {
      throw new NoSuchFileException(place.toString(), null, "there is no such file");
    }
    if (Files.isDirectory(place)) {
      return readAll(sources(place));
    }
    if (!isZip(place)) {
      if (!ArchivedFile.isModule(name(place))) {
        throw problem(place, "it is neither a zip nor a .src, .sub or .dat file");
      }
      return readAll(List.of(new Source(name(place), () -> Files.newInputStream(place), null)));
    }
    try (ZipFile zip = open(place)) {
      return readAll(sources(zip));
    }
  }

  private static FileSystemException problem(Path place, String reason) {
    return new FileSystemException(place.toString(), null, reason);
  }

  private static String name(Path file) {
    return String.valueOf(file.getFileName());
  }

  // zip

  /** Tells a zip from its first bytes: its name can end in anything. */
  private static boolean isZip(Path file) throws IOException {
    try (InputStream in = Files.newInputStream(file)) {
      byte[] start = in.readNBytes(4);
      return Arrays.equals(start, new byte[] {'P', 'K', 3, 4})
          || Arrays.equals(start, new byte[] {'P', 'K', 5, 6}); // without entries
    }
  }

  private static ZipFile open(Path file) throws IOException {
    try {
      return new ZipFile(file.toFile(), StandardCharsets.UTF_8);
    } catch (ZipException e) {
      return openWithOldNames(file);
    }
  }

  /** Returns whether a message of the JDK, at opening or at reading, is about a method. */
  private static boolean isMethod(String message) {
    return message.contains("compression method");
  }

  private static ZipFile openWithOldNames(Path file) throws IOException {
    boolean known = Charset.isSupported(ZIP_NAMES);
    try {
      return new ZipFile(
          file.toFile(), known ? Charset.forName(ZIP_NAMES) : StandardCharsets.ISO_8859_1);
    } catch (ZipException e) {
      String message = String.valueOf(e.getMessage());
      String reason = "the zip is damaged or incomplete: " + message;
      if (message.contains("encrypted")) {
        reason = "the zip is encrypted";
      } else if (isMethod(message)) {
        reason = UNSUPPORTED;
      }
      FileSystemException problem = problem(file, reason);
      problem.initCause(e);
      throw problem;
    }
  }

  private static List<Source> sources(ZipFile zip) throws IOException {
    List<Source> sources = new ArrayList<>();
    Enumeration<? extends ZipEntry> entries = zip.entries();
    while (entries.hasMoreElements()) {
      ZipEntry entry = entries.nextElement();
      if (!entry.isDirectory()) {
        Long checksum = entry.getCrc() < 0 ? null : entry.getCrc();
        String path = entry.getName().replace('\\', '/');
        add(sources, new Source(path, () -> zip.getInputStream(entry), checksum));
      }
    }
    return sources;
  }

  // folder

  private static List<Source> sources(Path folder) throws IOException {
    List<Source> sources = new ArrayList<>();
    Files.walkFileTree(
        folder,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult preVisitDirectory(Path each, BasicFileAttributes attributes) {
            boolean hidden = !each.equals(folder) && isHidden(name(each));
            return hidden ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes)
              throws IOException {
            if (attributes.isRegularFile()) {
              Opener opener = () -> Files.newInputStream(file);
              add(sources, new Source(path(folder, file), opener, null));
            }
            return FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFileFailed(Path file, IOException e) throws IOException {
            if (file.equals(folder)) {
              throw e;
            }
            Opener opener =
                () -> {
                  throw e;
                };
            add(sources, new Source(path(folder, file), opener, null));
            return FileVisitResult.CONTINUE;
          }
        });
    return sources;
  }

  private static String path(Path folder, Path file) {
    return folder.relativize(file).toString().replace('\\', '/');
  }

  private static void add(List<Source> sources, Source source) throws IOException {
    if (Arrays.stream(source.path().split("/", -1)).anyMatch(ArchiveReader::isHidden)) {
      return;
    }
    if (sources.size() == MAX_FILES) {
      throw new IOException("an archive has at most " + MAX_FILES + " files, has more");
    }
    sources.add(source);
  }

  private static boolean isHidden(String name) {
    return name.startsWith(".") && !name.equals(".") && !name.equals("..");
  }

  // both

  private List<ArchivedFile> readAll(List<Source> sources) {
    List<ArchivedFile> files = new ArrayList<>();
    for (boolean modules : new boolean[] {true, false}) {
      for (Source source : sources) {
        if (ArchivedFile.isModule(source.path()) == modules) {
          files.add(read(source));
        }
      }
    }
    return files;
  }

  private ArchivedFile read(Source source) {
    if (!isInside(source.path())) {
      return refused(
          source,
          "the path of a file in a zip is relative and has no .., is "
              + PrintableText.of(source.path()));
    }
    if (left == 0) {
      return refused(source, "the archive is too large");
    }
    int most = (int) Math.min(MAX_FILE, left);
    byte[] content;
    try (InputStream in = source.opener().open()) {
      content = in.readNBytes(most);
      left -= content.length;
      if (content.length == most && in.read() >= 0) {
        String limit = most == MAX_FILE ? "a file" : "what is left of the archive";
        return refused(source, limit + " has at most " + most + " bytes, has more");
      }
    } catch (ZipException e) {
      String message = String.valueOf(e.getMessage());
      return refused(source, isMethod(message) ? UNSUPPORTED : "the zip is damaged: " + message);
    } catch (EOFException e) {
      return refused(source, "the zip is damaged: " + e.getMessage());
    } catch (IOException e) {
      return refused(source, "cannot be read: " + e.getMessage());
    }
    return source.checksum() == null || source.checksum() == checksum(content)
        ? new ArchivedFile(source.path(), content, null)
        : refused(source, "the zip is damaged: the checksum of the file is wrong");
  }

  private static long checksum(byte[] content) {
    CRC32 checksum = new CRC32();
    checksum.update(content);
    return checksum.getValue();
  }

  /** Returns whether a path of a zip is what a folder could have. */
  private static boolean isInside(String path) {
    return !path.startsWith("/") && !Arrays.asList(path.split("/", -1)).contains("..");
  }

  private static ArchivedFile refused(Source source, String reason) {
    return new ArchivedFile(PrintableText.of(source.path()), NOTHING, reason);
  }
}
