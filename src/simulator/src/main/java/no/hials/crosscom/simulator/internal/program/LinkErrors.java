package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.Position;
import org.jspecify.annotations.Nullable;

/** Collects the errors of a module, and tells those of the statement that is being compiled. */
final class LinkErrors {
  private final List<KrlError> all = new ArrayList<>();

  /** The warnings of all modules. */
  private final Set<String> warned;

  private boolean complete;

  /** The first error of the statement; null without one. */
  private @Nullable String ofStatement;

  /**
   * @param warned the warnings that other modules have already, to which those of this one are
   *     added
   */
  LinkErrors(Set<String> warned) {
    this.warned = warned;
  }

  void add(Position position, String message) {
    if (!complete) {
      all.add(new KrlError(position, message));
    }
    stop(message);
  }

  /** Notes that the statement cannot be executed, for an error that was added before. */
  void stop(String message) {
    if (ofStatement == null) {
      ofStatement = message;
    }
  }

  /** Adds an error with which the statement can be executed, unless a module has it already. */
  void warn(Position position, String message) {
    if (!complete && warned.add(message)) {
      all.add(new KrlError(position, message));
    }
  }

  /** Compiles a statement or a part of it; returns its first error, null without one. */
  @Nullable String compile(Runnable compilation) {
    String around = ofStatement;
    ofStatement = null;
    compilation.run();
    String found = ofStatement;
    ofStatement = around;
    return found;
  }

  /**
   * Returns the errors in the order of the file, and keeps no more of them: those of a statement
   * that is compiled again are known.
   */
  List<KrlError> complete() {
    complete = true;
    return all.stream()
        .distinct()
        .sorted(
            Comparator.comparing((KrlError error) -> error.position().file())
                .thenComparing(error -> error.position().line())
                .thenComparing(error -> error.position().column()))
        .toList();
  }
}
