package no.hials.crosscom.cell;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Writes a line for every change that somebody makes: to {@code audit.jsonl}, and to those who
 * listen. Thread-safe.
 */
public final class AuditLog {
  private static final Logger LOG = LoggerFactory.getLogger(AuditLog.class);
  private static final int MAX_RECENT = 200;

  private final Path file;

  /** The lock for the file: a slow disk does not delay those who read {@link #recent}. */
  private final Object writing = new Object();

  private final Deque<String> recent = new ArrayDeque<>();
  private final List<Consumer<String>> listeners = new CopyOnWriteArrayList<>();

  /**
   * Something that somebody did.
   *
   * @param who the person or program
   * @param robot the name of the robot
   * @param what the kind, such as {@code write}
   * @param name what was changed, such as {@code $OV_PRO}; may be empty
   * @param before the value before; empty if it is not known
   * @param after the value after; empty if nothing was written
   * @param result {@code done}, or why it was not
   */
  public record Entry(
      String who,
      String robot,
      String what,
      String name,
      String before,
      String after,
      String result) {}

  /** Creates a log that writes into a folder. */
  public AuditLog(Path folder) {
    file = folder.resolve("audit.jsonl");
  }

  /** Calls something with each further line, which is an object of JSON. */
  public void addListener(Consumer<String> listener) {
    listeners.add(listener);
  }

  /** Writes a line. A change is made even if the line cannot be written; then it is logged. */
  public void add(Entry entry) {
    String line = line(Instant.now(), entry);
    synchronized (writing) {
      remember(line);
      try {
        Files.createDirectories(file.toAbsolutePath().getParent());
        Files.writeString(
            file,
            line + "\n",
            StandardCharsets.UTF_8,
            StandardOpenOption.CREATE,
            StandardOpenOption.APPEND);
      } catch (IOException | UncheckedIOException e) {
        LOG.warn("cannot write {}: {}; the line is {}", file, e.toString(), line);
      }
    }
    listeners.forEach(listener -> listener.accept(line));
  }

  private synchronized void remember(String line) {
    recent.addLast(line);
    if (recent.size() > MAX_RECENT) {
      recent.removeFirst();
    }
  }

  /** Returns the last lines, the oldest first. */
  public synchronized List<String> recent() {
    return List.copyOf(recent);
  }

  private static String line(Instant time, Entry entry) {
    return JsonLine.object(
        json -> {
          json.writeStringField("time", TimeText.instant(time));
          json.writeStringField("who", entry.who);
          json.writeStringField("robot", entry.robot);
          json.writeStringField("what", entry.what);
          json.writeStringField("name", entry.name);
          json.writeStringField("before", entry.before);
          json.writeStringField("after", entry.after);
          json.writeStringField("result", entry.result);
        });
  }
}
