package no.hials.crosscom.lang;

/** What a client may do with a variable. Java code may always do both. */
public enum Access {
  /** May be read only, such as {@code $POS_ACT}; a write is refused. */
  READ_ONLY,
  /** May be read and written. */
  READ_WRITE
}
