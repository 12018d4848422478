package no.hials.crosscom.gateway.internal.broker;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * The messages that the broker has not confirmed, in the order of sending. Their number and their
 * bytes are limited, but a single message may be larger. Not thread-safe.
 */
final class InFlight {
  /** The maximum number of messages. */
  private static final int MOST = 1000;

  /** The bytes of stored messages with which no other one is sent. */
  private static final int MOST_STORED = 32_000;

  /** The number of questions for a small window that is full. The client delays more than ten. */
  private static final int QUESTIONS = 8;

  /** The largest part of a window without a question, so that a slow connection has answers. */
  private static final int BYTES_PER_QUESTION = 8_000;

  private final Deque<Outgoing> messages = new ArrayDeque<>();
  private final SendWindow window = new SendWindow();

  /** The maximum number of messages like the last one. */
  private int most = MOST;

  /** The time from the last confirmation to the next message; 0 for no pause. */
  private long pause;

  private long doneAt;

  /** The bytes of the messages that are not done. */
  private long bytes;

  /** The bytes of the answers among them. */
  private long answerBytes;

  /** The bytes of the stored messages among them. */
  private long storedBytes;

  /** Whether nothing is sent until all messages are done, since one was late. */
  private boolean draining;

  boolean isEmpty() {
    return messages.isEmpty();
  }

  /**
   * Returns whether another message can be sent. If the oldest message is late, none can until all
   * are done: the next one then shows how long a round trip takes.
   *
   * @param now the time in nanoseconds
   */
  boolean hasRoom(long now) {
    Outgoing oldest = messages.peek();
    draining |= oldest != null && !oldest.done && window.mustDrain(oldest, now);
    boolean pausing = pause > 0 && now - doneAt < pause;
    return !draining && !pausing && messages.size() < most && bytes < window.size();
  }

  /**
   * Returns whether another answer to a command can be sent. Answers get half of the room, so that
   * a flood of commands does not stop the values.
   *
   * @param now the time in nanoseconds
   */
  boolean hasRoomForAnswer(long now) {
    return hasRoom(now) && answerBytes < window.size() / 2;
  }

  /**
   * Returns whether another stored message can be sent: less than half of the room is in use, and
   * no more for stored messages than a connection carries soon that has become slow.
   *
   * @param now the time in nanoseconds
   */
  boolean hasRoomForStored(long now) {
    return hasRoom(now) && bytes < window.size() / 2 && storedBytes < MOST_STORED;
  }

  /** Returns after how many bytes the broker is asked whether it has handled them. */
  int bytesPerQuestion() {
    return Math.min(BYTES_PER_QUESTION, window.size() / QUESTIONS);
  }

  /** Returns the names of the messages that the broker has not confirmed. */
  Set<String> names() {
    return messages.stream()
        .filter(one -> !one.done && !one.name.isEmpty())
        .map(one -> one.name)
        .collect(Collectors.toSet());
  }

  /**
   * Sets the maximum number of messages, which is never more than usual.
   *
   * @param nanos if not 0, messages are sent one at a time, each after a pause
   */
  void limit(int number, long nanos) {
    most = nanos > 0 ? 1 : Math.min(number, MOST);
    pause = nanos;
  }

  /** Adds a message that is sent now. */
  void add(Outgoing message) {
    messages.add(message);
    bytes += message.bytes;
    answerBytes += message.isAnswer ? message.bytes : 0;
    storedBytes += message.stored != null ? message.bytes : 0;
    message.waiting = bytes;
  }

  /**
   * Marks a message as done.
   *
   * @param now the time in nanoseconds
   */
  void done(Outgoing message, long now) {
    message.done = true;
    doneAt = now;
    bytes -= message.bytes;
    answerBytes -= message.isAnswer ? message.bytes : 0;
    storedBytes -= message.stored != null ? message.bytes : 0;
    window.confirmed(message, now);
  }

  /** Removes and returns the oldest message if it is done, or returns null. */
  @Nullable Outgoing pollDone() {
    Outgoing first = messages.peek();
    Outgoing done = first != null && first.done ? messages.poll() : null;
    if (done != null && messages.isEmpty()) {
      draining = false;
      window.drained();
    }
    return done;
  }

  /** Removes and returns the oldest message of a lost connection, or returns null at the end. */
  @Nullable Outgoing pollLost() {
    window.reset();
    draining = false;
    most = MOST;
    pause = 0;
    bytes = 0;
    answerBytes = 0;
    storedBytes = 0;
    return messages.poll();
  }
}
