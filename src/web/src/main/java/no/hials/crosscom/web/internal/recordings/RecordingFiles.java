package no.hials.crosscom.web.internal.recordings;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.Semaphore;
import java.util.regex.Pattern;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.web.internal.http.BrowserSession;
import no.hials.crosscom.web.internal.http.DeviceNames;
import no.hials.crosscom.web.internal.http.PageHandler;
import no.hials.crosscom.web.internal.http.Route;
import no.hials.crosscom.web.internal.socket.CommandException;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpMethod;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.io.Content;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;

/**
 * The files in the folder {@code recordings}. Every role may download them: {@code NAME.csv} is the
 * file, {@code NAME.csv/columns} its numbers, see {@link ReplayColumns}.
 */
final class RecordingFiles implements Route {
  static final int MAX_FILES = 500;

  /** A larger file can only be downloaded: its numbers would fill the memory of a browser. */
  static final long MAX_BYTES_TO_REPLAY = 16L * 1024 * 1024;

  static final String CSV = ".csv";
  static final String JSON_LINES = ".jsonl";

  private static final String COLUMNS = "/columns";
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9_-]{0,59}");

  /** More would fill the memory: each needs up to {@link ReplayColumns#MAX_BYTES}. */
  static final int MAX_OPENING = 8;

  private final Path folder;
  private final Semaphore opening = new Semaphore(MAX_OPENING);
  private final Object reading = new Object();

  RecordingFiles(Path folder) {
    this.folder = folder.resolve("recordings");
  }

  /**
   * A file.
   *
   * @param name its name with the ending
   * @param bytes its size
   * @param modified when it was last written
   */
  record RecordingEntry(String name, long bytes, Instant modified) {}

  /**
   * Returns the file of a new recording.
   *
   * @param name its name without the ending
   * @throws CommandException if the name is not allowed, or in use
   */
  Path newFile(String name, boolean jsonLines) throws IOException {
    if (!isAllowed(name)) {
      throw new CommandException(
          "the name of a recording must have 1 to 60 letters of A to Z, digits, - and _, begin with"
              + " a letter or digit, and must not be a device name of Windows");
    }
    if (list().size() >= MAX_FILES) {
      throw new CommandException("there are " + MAX_FILES + " recordings: delete one first");
    }
    Files.createDirectories(folder);
    Path file = path(name, jsonLines);
    if (isInUse(file, Set.of())) {
      throw new CommandException("there is already a recording " + file.getFileName());
    }
    return file;
  }

  /**
   * Returns the file of a new recording that nobody has named.
   *
   * @param name its name without the ending; a number follows if it is in use
   * @param others files that do not exist yet, but will
   */
  Path freeFile(String name, boolean jsonLines, Set<Path> others) throws IOException {
    String free = name;
    for (int i = 2; isInUse(path(free, jsonLines), others); i++) {
      free = name + "-" + i;
    }
    return newFile(free, jsonLines);
  }

  private Path path(String name, boolean jsonLines) {
    return folder.resolve(name + (jsonLines ? JSON_LINES : CSV));
  }

  private static boolean isInUse(Path file, Set<Path> others) {
    return others.contains(file) || Files.exists(file, LinkOption.NOFOLLOW_LINKS);
  }

  private static boolean isAllowed(String name) {
    return NAME.matcher(name).matches() && !DeviceNames.isDevice(name);
  }

  /** Returns whether there is a file; not for a link, which may lead out of the folder. */
  private static boolean isFile(Path file) {
    return Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS);
  }

  /**
   * Returns a file that exists.
   *
   * @param name its name with the ending
   */
  Path file(String name) throws CommandException {
    // checked before it becomes a path, so that no path leads out of the folder
    int dot = name.lastIndexOf('.');
    String ending = dot < 0 ? "" : name.substring(dot);
    if ((ending.equals(CSV) || ending.equals(JSON_LINES)) && isAllowed(name.substring(0, dot))) {
      Path file = folder.resolve(name);
      if (isFile(file)) {
        return file;
      }
    }
    throw new CommandException("there is no such recording");
  }

  /** Returns the files, the newest first. */
  List<RecordingEntry> list() throws IOException {
    List<RecordingEntry> all = new ArrayList<>();
    if (Files.isDirectory(folder)) {
      try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*.{csv,jsonl}")) {
        for (Path file : files) {
          String name = file.getFileName().toString();
          if (isAllowed(name.substring(0, name.lastIndexOf('.'))) && isFile(file)) {
            Instant modified = Files.getLastModifiedTime(file).toInstant();
            all.add(new RecordingEntry(name, Files.size(file), modified));
          }
        }
      }
    }
    all.sort(Comparator.comparing(RecordingEntry::modified).reversed());
    return all;
  }

  @Override
  public boolean handle(
      BrowserSession browser, String rest, Request request, Response response, Callback callback)
      throws IOException {
    boolean columns = rest.endsWith(COLUMNS);
    Path file;
    try {
      file = file(columns ? rest.substring(0, rest.length() - COLUMNS.length()) : rest);
    } catch (CommandException e) {
      return false;
    }
    if (!HttpMethod.GET.is(request.getMethod())) {
      return false;
    }
    if (columns) {
      return columns(file, response, callback);
    }
    String name = file.getFileName().toString();
    boolean csv = name.toLowerCase(Locale.ROOT).endsWith(CSV);
    response
        .getHeaders()
        .put(HttpHeader.CONTENT_TYPE, csv ? "text/csv; charset=utf-8" : "application/jsonl")
        .put(HttpHeader.CONTENT_DISPOSITION, "attachment; filename=\"" + name + "\"");
    Content.copy(Content.Source.from(file), response, callback);
    return true;
  }

  /**
   * Answers with the numbers, in its own thread: the threads of the server stay free for those who
   * want to stop a robot.
   */
  private boolean columns(Path file, Response response, Callback callback) throws IOException {
    long bytes = Files.size(file);
    if (bytes > MAX_BYTES_TO_REPLAY) {
      String reason =
          "A recording that is opened may have at most "
              + MAX_BYTES_TO_REPLAY
              + " bytes, this one has "
              + bytes
              + ". Download it instead.";
      return PageHandler.refuse(response, callback, HttpStatus.PAYLOAD_TOO_LARGE_413, reason);
    }
    if (!opening.tryAcquire()) {
      String reason = MAX_OPENING + " recordings are being opened already: try again soon.";
      return PageHandler.refuse(response, callback, HttpStatus.SERVICE_UNAVAILABLE_503, reason);
    }
    Callback done = Callback.from(callback, () -> opening.release());
    Thread thread = new Thread(() -> answer(file, response, done), "web-recording-opened");
    thread.setDaemon(true);
    thread.start();
    return true;
  }

  private void answer(Path file, Response response, Callback done) {
    ByteBuffer content;
    try {
      synchronized (reading) { // one at a time, since reading needs much memory
        content = ReplayColumns.read(file).bytes();
      }
    } catch (IOException e) {
      // viewers need not know the path of the folder
      String name = file.getFileName().toString();
      IOException shown =
          e instanceof CharacterCodingException ? FileException.cannot("read", file, e) : e;
      String reason = String.valueOf(shown.getMessage()).replace(file.toString(), name);
      boolean unused =
          PageHandler.refuse(response, done, HttpStatus.UNPROCESSABLE_ENTITY_422, reason);
      return;
    } catch (RuntimeException | OutOfMemoryError e) {
      done.failed(e);
      return;
    }
    response.getHeaders().put(HttpHeader.CONTENT_TYPE, "application/octet-stream");
    response.write(true, content, done);
  }
}
