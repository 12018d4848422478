package no.hials.crosscom.protocol.code;

import java.util.Optional;

/** How the server was built (c3-bridge.md, "build types"). */
public enum BuildType implements WireCode {
  /** Open source. */
  OPEN_SOURCE(0),
  /** Proprietary. */
  PROPRIETARY(1),
  /** Freeware. */
  FREEWARE(2),
  /** Internal. */
  INTERNAL(3);

  private final int code;

  BuildType(int code) {
    this.code = code;
  }

  @Override
  public int code() {
    return code;
  }

  /**
   * Finds a constant by its number.
   *
   * @param code any number
   * @return the constant, or nothing if the number is unknown
   */
  public static Optional<BuildType> from(int code) {
    return WireCode.find(BuildType.class, code);
  }
}
