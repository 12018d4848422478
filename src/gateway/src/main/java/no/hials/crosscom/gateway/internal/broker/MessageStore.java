package no.hials.crosscom.gateway.internal.broker;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps messages in files, in order, up to a maximum size, above which the oldest file is deleted.
 * A message is in its file when {@link #add} returns, so that it survives the end of the process. A
 * file is deleted when all its messages are confirmed. Not thread-safe.
 *
 * <p>A message in a file: length of the rest (4 bytes), CRC-32 of the rest without itself (4),
 * length of the topic (2), topic in UTF-8, payload.
 */
final class MessageStore implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(MessageStore.class);
  private static final String ENDING = ".messages";
  private static final String LEFT = "the stored messages in {} stay there for the next start: {}";
  private static final int HEADER = 8;
  private static final long MAX_FILE = 1_000_000;
  private static final int FILES = 8;

  private final Path folder;
  private final long limit;
  private final SessionFigures figures;
  private final Deque<Segment> segments = new ArrayDeque<>();
  private long nextNumber = 1;
  private long bytes;
  private long messages;

  /** The file that messages are added to, which is the last one; null if there is none. */
  private @Nullable FileChannel tail;

  /** The messages of the first file, while they are forwarded. */
  private @Nullable List<StoredMessage> first;

  private int handedOut;
  private int confirmed;
  private boolean failing;
  private boolean dropping;

  /** A file, with the number of its intact bytes and messages. */
  private static final class Segment {
    private final Path file;
    private long bytes;
    private int messages;

    Segment(Path file) {
      this.file = file;
    }
  }

  /** Opens the store with the messages of earlier runs. */
  MessageStore(Path folder, long limit, SessionFigures figures) {
    this.folder = folder;
    this.limit = limit;
    this.figures = figures;
    try (Stream<Path> files = Files.isDirectory(folder) ? Files.list(folder) : Stream.empty()) {
      for (Path file : files.filter(it -> it.toString().endsWith(ENDING)).sorted().toList()) {
        takeOver(file);
      }
    } catch (IOException e) {
      LOG.warn("cannot read the stored messages in {}: {}", folder, e.toString());
    }
    if (!isEmpty()) {
      LOG.info("{} messages of an earlier run are stored in {}", messages, folder);
    }
    showSize();
  }

  private void takeOver(Path file) {
    String name = file.getFileName().toString();
    try {
      nextNumber =
          Math.max(
              nextNumber, Long.parseLong(name.substring(0, name.length() - ENDING.length())) + 1);
    } catch (NumberFormatException e) {
      LOG.warn("{} is not a file of stored messages, and is left alone", file);
      return;
    }
    Segment segment = new Segment(file);
    try {
      segment.messages = read(segment, Files.readAllBytes(file)).size();
      if (segment.messages == 0) {
        Files.delete(file);
        return;
      }
    } catch (IOException e) {
      figures.damaged.inc();
      LOG.warn(LEFT, file, e.toString());
      return;
    }
    segments.add(segment);
    bytes += segment.bytes;
    messages += segment.messages;
  }

  /** Returns the messages up to the end or to the first damage, and records their size. */
  private List<StoredMessage> read(Segment segment, byte[] content) {
    List<StoredMessage> found = new ArrayList<>();
    ByteBuffer rest = ByteBuffer.wrap(content);
    while (rest.hasRemaining()) {
      StoredMessage message = message(rest);
      if (message == null) {
        figures.damaged.inc();
        LOG.warn(
            "{} is damaged at byte {}: the messages after it are lost",
            segment.file,
            rest.position());
        break;
      }
      found.add(message);
    }
    segment.bytes = rest.position();
    return found;
  }

  /** Returns the next message. If it is damaged, returns null and leaves the position unchanged. */
  private static @Nullable StoredMessage message(ByteBuffer rest) {
    int start = rest.position();
    if (rest.remaining() < HEADER) {
      return null;
    }
    int length = rest.getInt(start);
    if (length < Short.BYTES || length > rest.remaining() - HEADER) {
      return null;
    }
    ByteBuffer content = rest.slice(start + HEADER, length);
    int topicLength = Short.toUnsignedInt(content.getShort(0));
    if (crc(content) != rest.getInt(start + Integer.BYTES) || topicLength > length - Short.BYTES) {
      return null;
    }
    rest.position(start + HEADER + length);
    String topic = UTF_8.decode(content.slice(Short.BYTES, topicLength)).toString();
    int at = Short.BYTES + topicLength;
    return new StoredMessage(topic, content.slice(at, length - at).asReadOnlyBuffer());
  }

  private static int crc(ByteBuffer content) {
    CRC32 crc = new CRC32();
    crc.update(content.duplicate());
    return (int) crc.getValue();
  }

  private static ByteBuffer bytesOf(StoredMessage message) {
    byte[] topic = message.topic().getBytes(UTF_8);
    int length = Short.BYTES + topic.length + message.payload().remaining();
    ByteBuffer all = ByteBuffer.allocate(HEADER + length);
    all.putInt(length).putInt(0).putShort((short) topic.length).put(topic);
    all.put(message.payload().duplicate()).flip();
    return all.putInt(Integer.BYTES, crc(all.slice(HEADER, length)));
  }

  /** Adds a message. If it cannot be written to disk, it is lost, counted and logged. */
  void add(StoredMessage message) {
    ByteBuffer record = bytesOf(message);
    while (!segments.isEmpty() && bytes + record.remaining() > limit) {
      dropOldest();
    }
    try {
      write(record);
      figures.stored.inc();
      if (failing) {
        LOG.info("messages are stored in {} again", folder);
      }
      failing = false;
    } catch (IOException e) {
      figures.dropped("disk", 1);
      if (!failing) {
        LOG.error("cannot store messages in {}, they are lost: {}", folder, e.toString());
      }
      failing = true;
    }
    showSize();
  }

  /** Called when the broker is back, so that the log has the next failure, too. */
  void reachedBroker() {
    failing = false;
  }

  private void write(ByteBuffer record) throws IOException {
    Segment segment = segments.peekLast();
    FileChannel channel = tail;
    if (channel == null
        || segment == null
        || segment.bytes + record.remaining() > Math.min(MAX_FILE, limit / FILES)) {
      endFile();
      Files.createDirectories(folder);
      // also of a file that cannot be created: another may have this name
      Path file = folder.resolve(String.format(Locale.ROOT, "%019d%s", nextNumber++, ENDING));
      channel = FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
      tail = channel;
      segment = new Segment(file);
      segments.add(segment);
    }
    int size = record.remaining();
    try {
      while (record.hasRemaining()) {
        channel.write(record);
      }
    } catch (IOException e) {
      undo(channel, segment);
      throw e;
    }
    segment.bytes += size;
    segment.messages++;
    bytes += size;
    messages++;
  }

  /** Removes an incomplete message from the end of a file; if that fails, ends the file. */
  private void undo(FileChannel channel, Segment segment) {
    try {
      channel.truncate(segment.bytes);
    } catch (IOException e) {
      endFile();
    }
  }

  /** Closes the last file, so that the next message starts another. */
  private void endFile() {
    FileChannel channel = tail;
    tail = null;
    Segment last = segments.peekLast();
    try {
      if (channel != null) {
        channel.close();
      }
      if (last != null && last.messages == 0) {
        segments.removeLast();
        Files.deleteIfExists(last.file);
      }
    } catch (IOException e) {
      LOG.warn("{}: {}", folder, e.toString());
    }
  }

  private void dropOldest() {
    if (!dropping) {
      LOG.warn("the store {} is full: the oldest messages are lost", folder);
    }
    dropping = true;
    figures.dropped("full", segments.getFirst().messages - confirmed);
    removeFirst();
  }

  private void removeFirst() {
    Segment segment = takeOutFirst();
    if (segment != null) {
      try {
        Files.deleteIfExists(segment.file);
      } catch (IOException e) {
        LOG.warn("cannot delete {}: {}", segment.file, e.toString());
      }
    }
  }

  /** Takes the first file out of the store, and leaves it on the disk. */
  private @Nullable Segment takeOutFirst() {
    if (segments.size() == 1) {
      endFile();
    }
    Segment segment = segments.pollFirst();
    if (segment != null) {
      bytes -= segment.bytes;
      messages -= segment.messages - confirmed;
    }
    first = null;
    handedOut = 0;
    confirmed = 0;
    showSize();
    return segment;
  }

  /** Returns whether nothing is stored. */
  boolean isEmpty() {
    return messages == 0;
  }

  /** Returns the number of messages. */
  long size() {
    return messages;
  }

  /**
   * Returns the next message to forward; null if it is empty, or others must be confirmed before.
   */
  @Nullable StoredMessage next() {
    while (first == null && !isEmpty()) {
      load();
    }
    return first == null || handedOut == first.size() ? null : first.get(handedOut++);
  }

  /** Makes {@link #next} return its last message again. */
  void putBack() {
    handedOut--;
  }

  private void load() {
    dropping = false;
    if (segments.size() == 1) {
      endFile();
    }
    Segment segment = segments.getFirst();
    int expected = segment.messages;
    List<StoredMessage> found = List.of();
    long before = segment.bytes;
    try {
      byte[] content = Files.readAllBytes(segment.file);
      found = read(segment, Arrays.copyOf(content, (int) Math.min(before, content.length)));
      bytes += segment.bytes - before;
    } catch (NoSuchFileException e) {
      figures.damaged.inc();
      LOG.warn("{} is gone, its messages are lost", segment.file);
    } catch (IOException e) {
      // the file may be intact, as when the process has too many open files
      figures.damaged.inc();
      LOG.warn(LEFT, segment.file, e.toString());
      takeOutFirst();
      return;
    }
    figures.dropped("damaged", expected - found.size());
    messages += found.size() - expected;
    segment.messages = found.size();
    if (found.isEmpty()) {
      removeFirst();
    } else {
      first = found;
    }
  }

  /** Confirms that the broker has a message. Does nothing if its file was dropped meanwhile. */
  void confirm(StoredMessage message) {
    if (first == null || !first.get(confirmed).equals(message)) {
      return;
    }
    confirmed++;
    messages--;
    if (confirmed == first.size()) {
      removeFirst();
    }
    showSize();
  }

  /** Makes {@link #next} return the unconfirmed messages again. */
  void rewind() {
    handedOut = confirmed;
  }

  private void showSize() {
    figures.storedNow.set((double) messages);
    figures.storedBytes.set((double) bytes);
  }

  /** Stops writing, and removes the confirmed messages of the first file. */
  @Override
  public void close() {
    endFile();
    if (first == null || confirmed == 0) {
      return;
    }
    Path file = segments.getFirst().file;
    Path rest = file.resolveSibling(file.getFileName() + ".part");
    try (FileChannel channel =
        FileChannel.open(
            rest,
            StandardOpenOption.CREATE,
            StandardOpenOption.TRUNCATE_EXISTING,
            StandardOpenOption.WRITE)) {
      for (StoredMessage message : first.subList(confirmed, first.size())) {
        ByteBuffer record = bytesOf(message);
        while (record.hasRemaining()) {
          channel.write(record);
        }
      }
      Files.move(rest, file, StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      LOG.warn("{}: some of its messages will be sent twice: {}", file, e.toString());
    }
  }
}
