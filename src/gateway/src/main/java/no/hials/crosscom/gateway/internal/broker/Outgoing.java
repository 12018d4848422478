package no.hials.crosscom.gateway.internal.broker;

import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** A message that the broker has not confirmed yet. Used by the thread of the session. */
final class Outgoing {
  /** The approximate size of the topic and the headers. */
  private static final int OVERHEAD = 100;

  /** Its name for {@link Culprits}; empty if it has none. */
  String name;

  /** Goes to the store if the broker does not confirm the message; null to forget it. */
  final @Nullable Supplier<StoredMessage> spare;

  /** The stored message; null if the message is new. */
  final @Nullable StoredMessage stored;

  /** The approximate size of the packet; 0 if none is sent. */
  final int bytes;

  /** When the message was sent, in nanoseconds. */
  final long sentAt;

  /** Whether it is the answer to a command. */
  boolean isAnswer;

  /** The bytes that waited for the broker when the message was sent, with its own. */
  long waiting;

  /** Whether the broker has confirmed or refused the message. */
  boolean done;

  /**
   * Creates a message.
   *
   * @param now the time in nanoseconds
   */
  Outgoing(
      Publication message,
      @Nullable Supplier<StoredMessage> spare,
      @Nullable StoredMessage stored,
      long now) {
    this.name = stored == null ? message.topic() : stored.name();
    this.spare = spare;
    this.stored = stored;
    this.bytes = message.payload().remaining() + OVERHEAD;
    this.sentAt = now;
  }

  /** Creates a stored message that is not published. */
  Outgoing(StoredMessage stored) {
    this.name = "";
    this.spare = null;
    this.stored = stored;
    this.bytes = 0;
    this.sentAt = 0;
    this.done = true;
  }

  /** Returns whether it was sent while no other message waited for the broker. */
  boolean isAlone() {
    return waiting == bytes;
  }
}
