package no.hials.crosscom.simulator.internal.core;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;

/**
 * The system variables that determine how a motion is planned, as WITH sets them for one motion.
 */
final class MotionSettings {
  private static final List<String> NAMES = names();

  private final SystemVariableAccess access;

  MotionSettings(SystemVariableAccess access) {
    this.access = access;
  }

  private static List<String> names() {
    List<String> names = new ArrayList<>();
    names.addAll(List.of("$VEL", "$ACC", "$JERK", "$APO", "$TOOL", "$BASE", "$LOAD"));
    names.addAll(List.of("$ORI_TYPE", "$CIRC_TYPE", "$IPO_MODE"));
    for (int axis = 1; axis <= PositionValues.ROBOT_AXES; axis++) {
      for (String array : List.of("$VEL_AXIS", "$ACC_AXIS", "$GEAR_JERK")) {
        names.add(array + "[" + axis + "]");
      }
      for (String array : List.of("$VEL_EXTAX", "$ACC_EXTAX")) {
        names.add(array + "[" + axis + "]");
      }
    }
    return List.copyOf(names);
  }

  /** Returns the values of those that exist and have one. */
  Map<String, KrlValue> read() {
    Map<String, KrlValue> values = new HashMap<>();
    for (String name : NAMES) {
      access.value(name).ifPresent(value -> values.put(name, value));
    }
    return Map.copyOf(values);
  }

  void write(Map<String, KrlValue> values) {
    for (String name : NAMES) {
      KrlValue value = values.get(name);
      if (value != null && !value.equals(access.value(name).orElse(null))) {
        boolean unused = access.write(name, value);
      }
    }
  }

  /** Plans a motion. */
  interface Plan<T> {
    T plan() throws KrlExecutionException;
  }

  /**
   * Plans with other values, which hold only meanwhile; with the present ones if there are none.
   */
  <T> T with(Map<String, KrlValue> values, Plan<T> plan) throws KrlExecutionException {
    if (values.isEmpty()) {
      return plan.plan();
    }
    Map<String, KrlValue> before = read();
    write(values);
    try {
      return plan.plan();
    } finally {
      write(before);
    }
  }
}
