package no.hials.crosscom.protocol.value;

/** How a REAL is printed. */
public enum RealStyle {
  /** As a KR C4 prints it, KSS 8.3 and later: {@code 45.0000}, {@code 2.48660E+06} (krl.md 1.2). */
  KRC4,
  /** The fewest digits that give the same 32-bit float again: {@code 45.0}, {@code 2486600.0}. */
  SHORTEST
}
