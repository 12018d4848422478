package no.hials.crosscom.protocol.server;

import java.util.Collections;
import java.util.Set;
import java.util.TreeSet;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * The types of message that a server supports (type 14).
 *
 * @param types 0 to 255; one bit each in 32 bytes, the first with 255 to 248 and the last with 7 to
 *     0
 */
public record Features(Set<Integer> types) {
  /** Checks the ranges. */
  public Features {
    types.forEach(type -> Ranges.u8("type", type));
    types = Collections.unmodifiableSet(new TreeSet<>(types));
  }

  /**
   * Returns whether the server supports a type.
   *
   * @param type any
   * @return true if so
   */
  public boolean has(MessageType type) {
    return types.contains(type.code());
  }
}
