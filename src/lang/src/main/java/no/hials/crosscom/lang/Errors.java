package no.hials.crosscom.lang;

import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;

/** Collects the errors of a file, each of them once. */
final class Errors {
  private static final Comparator<KrlError> BY_PLACE =
      Comparator.<KrlError>comparingInt(error -> error.position().line())
          .thenComparingInt(error -> error.position().column());

  /** A file that is not KRL has an error on each line, and must not fill the memory. */
  static final int MAX = 10_000;

  private final String file;
  private final Set<KrlError> found = new LinkedHashSet<>();
  private @Nullable String damage;

  Errors(String file) {
    this.file = file;
  }

  /** Begins the next line: it has no damage yet. */
  void beginLine() {
    damage = null;
  }

  /** Returns the first error of the line that makes its tree wrong; null without one. */
  @Nullable String damage() {
    return damage;
  }

  /** Adds an error that makes the tree of the line wrong. */
  void add(Position position, String message) {
    add(position, message, true);
  }

  /**
   * Adds an error that makes the tree of the line wrong.
   *
   * @param reported whether it is not a consequence of another error
   */
  void add(Position position, String message, boolean reported) {
    if (reported) {
      note(position, message);
    }
    damage = damage == null ? message : damage;
  }

  /** Adds an error that leaves the tree of the line as it was meant. */
  void note(Position position, String message) {
    if (found.size() < MAX) {
      found.add(new KrlError(position, message));
    } else if (found.size() == MAX) {
      found.add(new KrlError(position, "more than " + MAX + " errors; the rest is not listed"));
    }
  }

  void add(Token token, String message) {
    add(at(token), message);
  }

  Position at(Token token) {
    return new Position(file, token.getLine(), token.getCharPositionInLine() + 1);
  }

  /** Returns the position of the first character. */
  Position start() {
    return new Position(file, 1, 1);
  }

  List<KrlError> inOrder() {
    // Unknown labels are found only at the end of a routine.
    return found.stream().sorted(BY_PLACE).toList();
  }
}
