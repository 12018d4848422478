package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.Position;
import org.jspecify.annotations.Nullable;

/** Collects the errors of a module, and tells those of the statement that is being compiled. */
final class LinkErrors {
  private final List<KrlError> all = new ArrayList<>();
  private final Set<String> warned = new HashSet<>();

  private int invalid;
  private boolean complete;

  /** The first error of the statement; null without one. */
  private @Nullable String ofStatement;

  void add(Position position, String message) {
    if (!complete) {
      all.add(new KrlError(position, message));
    }
    if (ofStatement == null) {
      ofStatement = message;
    }
  }

  /** Adds an error once, with which the statement can be executed. */
  void warn(Position position, String message) {
    if (!complete && warned.add(message)) {
      all.add(new KrlError(position, message));
    }
  }

  /**
   * Begins or ends a statement.
   *
   * @param other the error of the statement around it
   * @return the first error since the last call; null without one
   */
  @Nullable String exchange(@Nullable String other) {
    String found = ofStatement;
    ofStatement = other;
    return found;
  }

  /** Counts a line with an error of the parser, which has been reported. */
  void addInvalid() {
    invalid++;
  }

  int count() {
    return all.size() + invalid;
  }

  /**
   * Returns the errors in the order of the file, and keeps no more of them: those of a statement
   * that is compiled again are known.
   */
  List<KrlError> complete() {
    complete = true;
    return all.stream()
        .sorted(
            Comparator.comparing((KrlError error) -> error.position().file())
                .thenComparing(error -> error.position().line())
                .thenComparing(error -> error.position().column()))
        .toList();
  }
}
