package no.hials.crosscom.lang;

/** The access of clients to a variable. Java code can always read and write. */
public enum Access {
  /** Clients can only read the variable, such as {@code $POS_ACT}; a write is refused. */
  READ_ONLY,
  /** Clients can read and write the variable. */
  READ_WRITE
}
