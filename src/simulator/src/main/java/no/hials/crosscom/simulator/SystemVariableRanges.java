package no.hials.crosscom.simulator;

import java.util.List;
import java.util.Locale;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.internal.data.Scope;

/** The ranges of the system variables, for writes of clients and programs. */
final class SystemVariableRanges {
  private record Range(String name, int minimum, int maximum) {}

  private static final List<Range> ALL =
      List.of(
          // docs/reference/system-variables.md#override-and-speed
          new Range("$OV_PRO", 0, 100),
          new Range("$ADVANCE", 0, 5),
          // docs/reference/system-variables.md#inputs-outputs-and-timers
          new Range("$ANOUT", -1, 1),
          // in %; assumed that 0 and more than 100 are refused
          // (docs/reference/system-variables.md#override-and-speed)
          new Range("$OV_JOG", 0, 100),
          new Range("$VEL_AXIS", 1, 100),
          new Range("$ACC_AXIS", 1, 100),
          new Range("$VEL_EXTAX", 1, 100),
          new Range("$ACC_EXTAX", 1, 100));

  private SystemVariableRanges() {}

  static void guard(Scope scope) {
    for (Range range : ALL) {
      scope.guard(range.name(), (path, value) -> check(range, value));
    }
  }

  private static void check(Range range, KrlValue value) throws RefusedException {
    if (value instanceof KrlArray array) {
      for (KrlValue element : array.elements()) {
        check(range, element);
      }
      return;
    }
    double number;
    if (value instanceof KrlInt integer) {
      number = integer.value();
    } else if (value instanceof KrlReal real) {
      number = real.value();
    } else {
      return; // the type of the variable refuses it
    }
    if (!(number >= range.minimum() && number <= range.maximum())) {
      throw new RefusedException(
          Refusal.OUT_OF_RANGE,
          String.format(
              Locale.ROOT,
              "must be %d to %d, was given %s",
              range.minimum(),
              range.maximum(),
              value.print()));
    }
  }
}
