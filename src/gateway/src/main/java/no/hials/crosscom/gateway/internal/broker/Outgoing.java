package no.hials.crosscom.gateway.internal.broker;

import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** A message that the broker has not confirmed yet. Used by the thread of the session. */
final class Outgoing {
  /** Goes to the store if the broker does not confirm the message; null to forget it. */
  final @Nullable Supplier<StoredMessage> spare;

  /** The stored message; null if the message is new. */
  final @Nullable StoredMessage stored;

  /** The size of the message if only a round trip confirms it; otherwise 0. */
  final int bytes;

  boolean done;

  Outgoing(
      Publication message,
      @Nullable Supplier<StoredMessage> spare,
      @Nullable StoredMessage stored) {
    this.spare = spare;
    this.stored = stored;
    this.bytes = message.qos() == 0 ? message.payload().remaining() : 0;
  }

  /** Creates a stored message that is not published. */
  Outgoing(StoredMessage stored) {
    this.spare = null;
    this.stored = stored;
    this.bytes = 0;
    this.done = true;
  }
}
