package no.hials.crosscom.lang;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Checks the labels of a routine and the jumps to them. */
final class Jumps {
  /**
   * A label or a jump.
   *
   * @param around the lists of statements around it, the innermost last
   */
  private record Place(Position position, String label, List<List<Statement>> around) {}

  private final Errors errors;
  private final Map<String, Place> labels = new HashMap<>();
  private final List<Place> jumps = new ArrayList<>();

  Jumps(Errors errors) {
    this.errors = errors;
  }

  void label(Statement.Label label, List<List<Statement>> around) {
    Place place = new Place(label.position(), label.name(), around);
    Place first = labels.putIfAbsent(key(label.name()), place);
    if (first != null) {
      errors.add(
          label.position(),
          "the label " + label.name() + " is already in line " + first.position().line());
    }
  }

  void jump(Statement.Goto jump, List<List<Statement>> around) {
    jumps.add(new Place(jump.position(), jump.label(), around));
  }

  /** Reports jumps to unknown labels and jumps into a block (assumed to be forbidden). */
  void check() {
    for (Place jump : jumps) {
      Place label = labels.get(key(jump.label()));
      if (label == null) {
        errors.add(jump.position(), "unknown label " + jump.label());
      } else if (!isAround(label.around(), jump.around())) {
        errors.add(
            jump.position(),
            "GOTO into a block: the label "
                + jump.label()
                + " is in line "
                + label.position().line());
      }
    }
  }

  private static boolean isAround(List<List<Statement>> outer, List<List<Statement>> inner) {
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
