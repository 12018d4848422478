package no.hials.crosscom.cell;

import java.io.FileOutputStream;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
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

  private int missing; // guarded by writing
  private volatile String failure = "";

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

  /**
   * Writes a line. A change is made even if the line cannot be written; then it is logged, and the
   * next line that can be written says how many are missing before it.
   */
  public void add(Entry entry) {
    Instant now = Instant.now();
    List<String> lines = new ArrayList<>(List.of(line(now, entry)));
    synchronized (writing) {
      if (missing > 0) {
        lines.add(0, line(now, gap()));
      }
      try {
        append(String.join("\n", lines) + "\n");
        missing = 0;
        failure = "";
      } catch (IOException e) {
        lines = List.of(lines.get(lines.size() - 1));
        missing++;
        failure = FileException.reason(e);
        LOG.warn("cannot write {}: {}; the line is {}", file, failure, lines.get(0));
      }
      lines.forEach(this::remember);
    }
    lines.forEach(line -> listeners.forEach(listener -> listener.accept(line)));
  }

  /** Returns why the last line could not be written; empty if it was. */
  public String failure() {
    return failure;
  }

  private Entry gap() {
    String count = missing == 1 ? "1 line is" : missing + " lines are";
    String result = count + " missing before this one: " + failure;
    return new Entry("jopenshowvar", "", "audit", file.getFileName().toString(), "", "", result);
  }

  /** Appends whole lines, or nothing. */
  private void append(String lines) throws IOException {
    Files.createDirectories(file.toAbsolutePath().getParent());
    boolean whole = endsWithWholeLine();
    byte[] bytes = ((whole ? "" : "\n") + lines).getBytes(StandardCharsets.UTF_8);
    long before = file.toFile().length();
    // not a channel, which an interrupt of the thread closes
    try (FileOutputStream out = new FileOutputStream(file.toFile(), true)) {
      out.write(bytes);
    } catch (IOException e) {
      cut(before, bytes, e);
      throw e;
    }
  }

  /** Returns whether a line may follow: a process that was killed may have left half of one. */
  private boolean endsWithWholeLine() throws IOException {
    if (file.toFile().length() == 0) {
      return true;
    }
    try (RandomAccessFile in = new RandomAccessFile(file.toFile(), "r")) {
      in.seek(in.length() - 1);
      return in.read() == '\n';
    }
  }

  /** Removes the part of some bytes that was written, unless another process appended to it. */
  private void cut(long before, byte[] bytes, IOException failed) {
    if (file.toFile().length() <= before) {
      return;
    }
    try (RandomAccessFile out = new RandomAccessFile(file.toFile(), "rw")) {
      byte[] written = new byte[(int) Math.min(out.length() - before, bytes.length)];
      out.seek(before);
      out.readFully(written);
      if (out.length() == before + written.length
          && Arrays.equals(written, Arrays.copyOf(bytes, written.length))) {
        out.setLength(before);
      }
    } catch (IOException e) {
      failed.addSuppressed(e); // the next line begins with a line break
    }
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
