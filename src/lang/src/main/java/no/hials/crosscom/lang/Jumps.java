package no.hials.crosscom.lang;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import no.hials.crosscom.lang.internal.PackedList;
import org.jspecify.annotations.Nullable;

/** Checks the labels of a routine and the jumps to them. */
final class Jumps {
  /**
   * A label or a jump.
   *
   * @param around the lists of statements around it, the innermost last
   * @param index its index in the innermost list
   */
  private record Place(
      Position position, String label, List<PackedList<Statement>> around, int index) {
    static Place of(Position position, String label, List<PackedList<Statement>> around) {
      return new Place(position, label, around, around.get(around.size() - 1).size());
    }

    void invalidate(String reason) {
      around.get(around.size() - 1).replace(index, new Statement.Invalid(position, reason));
    }
  }

  private final Errors errors;
  private final Map<String, Place> labels = new HashMap<>();
  private final List<Place> jumps = new ArrayList<>();

  Jumps(Errors errors) {
    this.errors = errors;
  }

  /** Adds a label, which is appended to the innermost list next. */
  void label(Statement.Label label, List<PackedList<Statement>> around) {
    Place place = Place.of(label.position(), label.name(), around);
    Place first = labels.putIfAbsent(key(label.name()), place);
    if (first != null) {
      errors.add(
          label.position(),
          "the label " + label.name() + " is already in line " + first.position().line());
    }
  }

  /** Adds a jump, which is appended to the innermost list next. */
  void jump(Statement.Goto jump, List<PackedList<Statement>> around) {
    jumps.add(Place.of(jump.position(), jump.label(), around));
  }

  /**
   * Reports jumps to unknown labels and jumps into a block (assumed to be forbidden); they become
   * invalid.
   */
  void check() {
    for (Place jump : jumps) {
      String error = error(jump, labels.get(key(jump.label())));
      if (error != null) {
        errors.add(jump.position(), error);
        jump.invalidate(error);
      }
    }
  }

  private static @Nullable String error(Place jump, @Nullable Place label) {
    if (label == null) {
      return "unknown label " + jump.label();
    }
    return isAround(label.around(), jump.around())
        ? null
        : "GOTO into a block: the label " + jump.label() + " is in line " + label.position().line();
  }

  @SuppressWarnings("ReferenceEquality") // other blocks can have equal statements
  private static boolean isAround(
      List<PackedList<Statement>> outer, List<PackedList<Statement>> inner) {
    if (outer.size() > inner.size()) {
      return false;
    }
    for (int i = 0; i < outer.size(); i++) {
      if (outer.get(i) != inner.get(i)) {
        return false;
      }
    }
    return true;
  }

  private static String key(String label) {
    return label.toUpperCase(Locale.ROOT);
  }
}
