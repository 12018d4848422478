package no.hials.crosscom.protocol.value;

/** The ways to print a REAL. */
public enum RealStyle {
  /**
   * As a KR C4 prints it, KSS 8.3 and later: {@code 45.0000}, {@code 2.48660E+06}
   * (docs/reference/krl-values.md#real).
   */
  KRC4,
  /** The fewest digits that are read as the same 32-bit float: {@code 45.0}, {@code 2486600.0}. */
  SHORTEST
}
