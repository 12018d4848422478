package no.hials.crosscom.c3;

/** How it is made sure that what arrived is what was sent. */
public enum Verification {
  /** By the size of every part and of the whole, while it is transferred. */
  PARTS,
  /** As {@link #PARTS}, and after an upload by the size of the file on the controller. */
  SIZE,
  /** As {@link #SIZE}, and by reading the file once more and comparing all bytes. */
  CONTENT
}
