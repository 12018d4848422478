package no.hials.crosscom.gateway.internal.broker;

import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** A message that the broker has not confirmed yet. Used by the thread of the session. */
final class Outgoing {
  /** Goes to the store if the broker does not confirm the message; null to forget it. */
  final @Nullable Supplier<StoredMessage> spare;

  /** The stored message; null if the message is new. */
  final @Nullable StoredMessage stored;

  boolean done;

  Outgoing(@Nullable Supplier<StoredMessage> spare, @Nullable StoredMessage stored) {
    this.spare = spare;
    this.stored = stored;
  }

  /** Returns whether the message is published again if the broker does not get it. */
  boolean isKept() {
    return spare != null || stored != null;
  }
}
