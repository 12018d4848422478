package no.hials.crosscom.protocol;

import java.util.HexFormat;

/** Bytes as the tests write them: pairs of hexadecimal digits, blanks, and comments after #. */
final class Hex {
  private Hex() {}

  static byte[] bytes(String text) {
    return HexFormat.of().parseHex(text.replaceAll("#.*", "").replaceAll("\\s+", ""));
  }
}
