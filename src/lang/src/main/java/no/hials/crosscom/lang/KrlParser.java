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
   *     encoding
   * @return the tree and the errors
   */
  public static ParseResult parse(String fileName, String text) {
    return new FileBuilder(fileName, KrlEncoding.withoutMark(text)).build();
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
