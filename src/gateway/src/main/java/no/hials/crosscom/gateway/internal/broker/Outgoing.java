package no.hials.crosscom.gateway.internal.broker;

import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** A message that the broker has not confirmed yet. Used by the thread of the session. */
final class Outgoing {
  /** The approximate size of the topic and the headers. */
  private static final int OVERHEAD = 100;

  /** Its name for {@link Culprits}; empty if it has none. */
  final String name;

  /** Goes to the store if the broker does not confirm the message; null to forget it. */
  final @Nullable Supplier<StoredMessage> spare;

  /** The stored message; null if the message is new. */
  final @Nullable StoredMessage stored;

  /** The approximate size of the packet; 0 if none is sent. */
  final int bytes;

  /** When the message was sent, in nanoseconds. */
  final long sentAt;

  /** Whether it is the answer to a command. */
  final boolean isAnswer;

  /** The bytes that waited for the broker when the message was sent, with its own. */
  long waiting;

  /** Whether the broker has confirmed or refused the message. */
  boolean done;

  private Outgoing(
      String name,
      @Nullable Supplier<StoredMessage> spare,
      @Nullable StoredMessage stored,
      int bytes,
      long sentAt,
      boolean isAnswer) {
    this.name = name;
    this.spare = spare;
    this.stored = stored;
    this.bytes = bytes;
    this.sentAt = sentAt;
    this.isAnswer = isAnswer;
  }

  private static int bytes(Publication message) {
    return message.payload().remaining() + OVERHEAD;
  }

  /**
   * Returns a new message.
   *
   * @param now the time in nanoseconds
   */
  static Outgoing of(Publication message, @Nullable Supplier<StoredMessage> spare, long now) {
    return new Outgoing(message.topic(), spare, null, bytes(message), now, false);
  }

  /** Returns a message that is sent whatever holds others back. */
  static Outgoing atOnce(Publication message, boolean isAnswer, long now) {
    return new Outgoing("", null, null, bytes(message), now, isAnswer);
  }

  /** Returns a stored message with a name. */
  static Outgoing stored(Publication message, StoredMessage stored, String name, long now) {
    return new Outgoing(name, null, stored, bytes(message), now, false);
  }

  /** Returns a stored message that is not published. */
  static Outgoing skipped(StoredMessage stored) {
    Outgoing skipped = new Outgoing("", null, stored, 0, 0, false);
    skipped.done = true;
    return skipped;
  }

  /** Returns whether it was sent while no other message waited for the broker. */
  boolean isAlone() {
    return waiting == bytes;
  }
}
