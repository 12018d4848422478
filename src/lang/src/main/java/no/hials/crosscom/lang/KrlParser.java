package no.hials.crosscom.lang;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Parses files of KRL.
 *
 * <p>Whether a file is a program or a data list is told from what stands in it, not from its name.
 * What is wrong in a file is reported with its place, and the rest of the file is checked all the
 * same; bad KRL never throws. Thread-safe: it keeps nothing.
 */
public final class KrlParser {
  /** A byte order mark, and what is left of its bytes in UTF-8 where they were read as latin-1. */
  private static final List<String> MARKS = List.of("\uFEFF", "\u00EF\u00BB\u00BF");

  private KrlParser() {}

  /**
   * Parses a file. It is read as ISO 8859-1 (krl.md 4: latin-1), so every byte is a character; a
   * UTF-8 mark at its beginning is skipped.
   *
   * @param file the file; as it is written here it stands in the positions
   * @return the tree and what is wrong
   * @throws IOException if it cannot be read
   */
  public static ParseResult parse(Path file) throws IOException {
    return parse(file.toString(), Files.readString(file, StandardCharsets.ISO_8859_1));
  }

  /**
   * Parses a text.
   *
   * @param fileName what the positions call it
   * @param text the contents of a {@code .src}, {@code .sub} or {@code .dat} file, with either kind
   *     of line end; a byte order mark at its beginning is skipped, also one of UTF-8 that was read
   *     as ISO 8859-1
   * @return the tree and what is wrong
   */
  public static ParseResult parse(String fileName, String text) {
    String bare = text;
    for (String mark : MARKS) {
      if (text.startsWith(mark)) {
        bare = text.substring(mark.length());
      }
    }
    return new FileBuilder(fileName, bare).build();
  }
}
