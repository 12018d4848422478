package no.hials.crosscom.protocol;

import java.util.Collections;
import java.util.EnumSet;
import java.util.Set;

/** The servers that speak this protocol, by what they know of it. */
public enum ServerType {
  /** KUKAVARPROXY: functions 0 to 3 (kukavarproxy.md, "Frames"). */
  KUKAVARPROXY,
  /** C3 Bridge Interface: all but functions 2 and 3 (c3-bridge.md, "Common to all messages"). */
  C3_BRIDGE;

  /**
   * Gives the types of message that this server knows, in its newest version.
   *
   * @return the types, unmodifiable
   */
  public Set<MessageType> types() {
    EnumSet<MessageType> types = EnumSet.allOf(MessageType.class);
    types.removeIf(type -> !type.isKnownTo(this));
    return Collections.unmodifiableSet(types);
  }
}
