package no.hials.crosscom.simulator;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.internal.data.BuiltInDataLists;

/** The variables of the simulated controller, from the data lists in the jar, and their ranges. */
final class BuiltInTable {
  /** The range of a variable, for writes of clients and programs. */
  private record Range(String name, int minimum, int maximum) {}

  private static final List<Range> RANGES =
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

  /** The variables that have their positions from the lists until a controller is created. */
  private static final List<String> AXES_AT_HOME =
      List.of("$AXIS_ACT", "$AXIS_ACT_MEAS", "$AXIS_FOR", "$AXIS_BACK", "$AXIS_RET");

  private static final List<String> FLANGE_AT_HOME =
      List.of("$POS_ACT", "$POS_ACT_MES", "$POS_FOR", "$POS_BACK", "$POS_RET");

  /** Never changed, only copied. */
  static final VariableTable KRC4 = krc4();

  private BuiltInTable() {}

  private static VariableTable krc4() {
    VariableTable table = load(BuiltInDataLists.NAMES);
    for (Range range : RANGES) {
      table.scope().guard(range.name(), (path, value) -> check(range, value));
    }
    table.forgetRobotData();
    return table;
  }

  static VariableTable of(RobotModel robot) {
    VariableTable table = KRC4.copy();
    // the lists in the jar have its machine data, as they are on a real controller
    if (!robot.equals(RobotModel.kr6r900sixx())) {
      Map<String, KrlValue> data = robot.machineData();
      data.forEach(table::set);
      KrlValue home = Objects.requireNonNull(data.get("XHOME"));
      AXES_AT_HOME.forEach(name -> table.set(name, home));
      KrlValue flange = flange(robot);
      FLANGE_AT_HOME.forEach(name -> table.set(name, flange));
    }
    return table;
  }

  /** Returns the flange of a robot at home as an E6POS. */
  private static KrlValue flange(RobotModel robot) {
    Frame frame = robot.forward(robot.home());
    return KrlValue.parse(
        String.format(
            Locale.ROOT,
            "{X %s,Y %s,Z %s,A %s,B %s,C %s,S %d,T %d}",
            frame.x(),
            frame.y(),
            frame.z(),
            frame.a(),
            frame.b(),
            frame.c(),
            robot.status(robot.home()),
            robot.turn(robot.home())));
  }

  /** Returns a table of some data lists in the jar. */
  static VariableTable load(List<String> files) {
    VariableTable table = VariableTable.empty();
    for (String file : files) {
      try {
        table.load(file, BuiltInDataLists.text(file));
      } catch (IOException | KrlFileException e) {
        throw new IllegalStateException("a data list in the jar is wrong: " + e.getMessage(), e);
      }
    }
    return table;
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
