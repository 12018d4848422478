package no.hials.crosscom.cli.drive;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import no.hials.crosscom.control.DriveSpace;
import no.hials.crosscom.control.input.Input;

/** The numbers of a drive for people. */
final class DriveText {
  private DriveText() {}

  /** Shows six numbers with their names. */
  static String shown(DriveSpace space, List<Double> six) {
    List<String> parts = new ArrayList<>();
    for (int i = 0; i < six.size(); i++) {
      parts.add(String.format(Locale.ROOT, "%s %.1f", space.names().get(i), six.get(i)));
    }
    return String.join(" ", parts);
  }

  /** Shows which deflections are not 0. */
  static String shown(DriveSpace space, Input input) {
    List<String> parts = new ArrayList<>();
    for (int i = 0; i < space.names().size(); i++) {
      if (input.axis(i) != 0) {
        parts.add(
            String.format(Locale.ROOT, "%s %+.0f%%", space.names().get(i), 100 * input.axis(i)));
      }
    }
    return parts.isEmpty() ? "none" : String.join(" ", parts);
  }
}
