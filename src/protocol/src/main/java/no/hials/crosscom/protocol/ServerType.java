package no.hials.crosscom.protocol;

import java.util.Collections;
import java.util.EnumSet;
import java.util.Set;

/** The servers that speak this protocol, and the types of message they support. */
public enum ServerType {
  /** KUKAVARPROXY: functions 0 to 3 (docs/reference/wire-format.md#requests). */
  KUKAVARPROXY,
  /** C3 Bridge Interface: all but functions 2 and 3 (docs/reference/c3-messages.md). */
  C3_BRIDGE;

  /**
   * Returns the types of message that the newest version of this server supports.
   *
   * @return the types, unmodifiable
   */
  public Set<MessageType> types() {
    EnumSet<MessageType> types = EnumSet.allOf(MessageType.class);
    types.removeIf(type -> !type.isKnownTo(this));
    return Collections.unmodifiableSet(types);
  }
}
