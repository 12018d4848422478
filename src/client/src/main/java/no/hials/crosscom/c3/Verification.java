package no.hials.crosscom.c3;

/** How to check that all bytes of a transfer arrived. */
public enum Verification {
  /** Compares the size of every part and of the whole file during the transfer. */
  PARTS,
  /** As {@link #PARTS}; after an upload, also compares the size of the file on the controller. */
  SIZE,
  /** As {@link #SIZE}; also reads the file again and compares all bytes. */
  CONTENT
}
