package no.hials.crosscom.lang;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import no.hials.crosscom.protocol.value.KrlEncoding;

/**
 * Parses KRL files.
 *
 * <p>The contents decide whether a file is a program or a data list, not its name. Each error is
 * reported with its position, and the rest of the file is still checked; invalid KRL never throws.
 * Thread-safe, since it has no state.
 */
public final class KrlParser {
  private static final char DOS_END = 0x1A;

  private KrlParser() {}

  /**
   * Parses a file, in Windows-1252 or UTF-8 as its contents say; a byte order mark is skipped.
   *
   * @param file the file; positions name it by this path
   * @return the tree and the errors
   * @throws IOException if the file cannot be read
   */
  public static ParseResult parse(Path file) throws IOException {
    return parse(file.toString(), KrlEncoding.decode(Files.readAllBytes(file)));
  }

  /**
   * Parses a text.
   *
   * @param fileName the name of the file in positions
   * @param text the contents of a {@code .src}, {@code .sub} or {@code .dat} file, with either kind
   *     of line end; a byte order mark is skipped, even a UTF-8 mark that was read as another
   *     encoding; 0x1A at the end is skipped, and a form feed is a blank
   * @return the tree and the errors
   */
  public static ParseResult parse(String fileName, String text) {
    return new FileBuilder(fileName, plain(KrlEncoding.withoutMark(text))).build();
  }

  /**
   * Removes the end of file of DOS, and replaces form feeds by blanks, which old editors write
   * (assumed: docs/reference/krl-language.md#files).
   */
  private static String plain(String text) {
    int end = text.length();
    while (end > 0 && Character.isWhitespace(text.charAt(end - 1))) {
      end--;
    }
    boolean dos = end > 0 && text.charAt(end - 1) == DOS_END;
    while (dos && end > 0 && text.charAt(end - 1) == DOS_END) {
      end--;
    }
    String rest = dos ? text.substring(0, end) : text;
    return rest.indexOf('\f') < 0 ? rest : withoutFormFeeds(rest);
  }

  /** Replaces form feeds outside of texts in quotes. */
  private static String withoutFormFeeds(String text) {
    StringBuilder plain = new StringBuilder(text);
    boolean quoted = false;
    for (int i = 0; i < plain.length(); i++) {
      char c = plain.charAt(i);
      quoted = c != '\n' && quoted != (c == '"');
      if (c == '\f' && !quoted) {
        plain.setCharAt(i, ' ');
      }
    }
    return plain.toString();
  }

  /**
   * Parses a declaration that is not in a file: {@code REAL X,Y[3]}, {@code SIGNAL S $OUT[1] TO
   * $OUT[8]}, or {@code STRUC WELD REAL SPEED, INT SEAM}. A name can be a keyword here and can be
   * longer than 24 characters; modifiers, initial values and comments are errors.
   *
   * @param text the declaration
   * @param errors receives the errors; their positions have no file name
   * @return the variables, the signal or the type; empty if there is an error
   */
  public static Optional<Declaration> parseDeclaration(String text, Consumer<KrlError> errors) {
    Errors found = new Errors("");
    Declaration declaration = SingleDeclaration.parse(text, found);
    found.inOrder().forEach(errors);
    return found.inOrder().isEmpty() ? Optional.ofNullable(declaration) : Optional.empty();
  }
}
