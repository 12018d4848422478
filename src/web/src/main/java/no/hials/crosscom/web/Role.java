package no.hials.crosscom.web;

/** The rights of a browser; each role has those of the roles before it. */
public enum Role {
  /** Sees everything and changes nothing. */
  VIEW,
  /** Unlocks robots, writes variables, and starts and stops programs. */
  OPERATE,
  /** Also moves robots by hand. */
  JOG;

  /** Returns whether this role has the rights of another. */
  public boolean includes(Role needed) {
    return compareTo(needed) >= 0;
  }
}
