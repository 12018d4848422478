package no.hials.crosscom.protocol;

import java.util.Collections;
import java.util.Set;
import java.util.TreeSet;

/**
 * The types of message that a server knows (c3-bridge.md, type 14).
 *
 * @param types one bit each in 32 bytes, of which the first has 255 to 248 and the last 7 to 0; 0
 *     to 255
 */
public record Features(Set<Integer> types) {
  static final int LENGTH = 32;

  /** Checks the ranges. */
  public Features {
    types.forEach(type -> Ranges.u8("type", type));
    types = Collections.unmodifiableSet(new TreeSet<>(types));
  }

  /**
   * Says whether the server knows a type.
   *
   * @param type any
   * @return true if so
   */
  public boolean has(MessageType type) {
    return types.contains(type.code());
  }

  static Features read(WireBuffer in) throws MalformedFrameException {
    byte[] bytes = in.bytes(LENGTH, "features").toByteArray();
    Set<Integer> types = new TreeSet<>();
    for (int type = 0; type < 8 * LENGTH; type++) {
      if ((bytes[index(type)] & bit(type)) != 0) {
        types.add(type);
      }
    }
    return new Features(types);
  }

  void write(WireBuffer out) {
    byte[] bytes = new byte[LENGTH];
    for (int type : types) {
      bytes[index(type)] |= (byte) bit(type);
    }
    out.putBytes(Bytes.of(bytes));
  }

  private static int index(int type) {
    return LENGTH - 1 - type / 8;
  }

  private static int bit(int type) {
    return 1 << type % 8;
  }
}
