package no.hials.crosscom.web.internal.programs;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.web.internal.programs.MoveChecks.Check;
import no.hials.crosscom.web.internal.programs.MoveChecks.State;

/**
 * Checks the variable that a program of krl follows: whether it asks for a motion
 * (docs/how-to/use-the-krl-programs.md).
 */
final class FollowedVariable {
  /** The distance to a target that counts as reached, mm or degrees. */
  private static final double REACHED = 0.01;

  private static final List<String> FRAME = List.of("X", "Y", "Z", "A", "B", "C");
  private static final List<String> AXES = List.of("A1", "A2", "A3", "A4", "A5", "A6");

  private FollowedVariable() {}

  /** Returns the check of the selected program; none if it is not one of krl. */
  static Optional<Check> check(ReadValues values) {
    return switch (values.text("$PRO_NAME1[]").toUpperCase(Locale.ROOT)) {
      case "ACTUATOR" -> Optional.of(increment(values, "MYPOS"));
      case "EXT_MOVE_AXIS" -> Optional.of(increment(values, "MYAXIS"));
      case "FOLLOW_POS" -> Optional.of(target(values, "JOV_POS", "$POS_ACT", FRAME));
      case "FOLLOW_AXIS" -> Optional.of(target(values, "JOV_AXIS", "$AXIS_ACT", AXES));
      case "PLAY_PATH" -> Optional.of(command(values));
      default -> Optional.empty();
    };
  }

  private static Check increment(ReadValues values, String variable) {
    boolean zero =
        values.get(variable) instanceof KrlStruct increment
            && increment.fields().stream()
                .filter(field -> !Set.of("S", "T").contains(field.name()))
                .allMatch(field -> ReadValues.number(field.value()) == 0);
    return check(
        values,
        variable,
        zero,
        "The program adds " + variable + " again and again, and it is all zeros.");
  }

  private static Check target(
      ReadValues values, String target, String actual, List<String> fields) {
    boolean reached =
        values.get(target) instanceof KrlStruct to
            && values.get(actual) instanceof KrlStruct at
            && fields.stream().allMatch(field -> isEqual(to, at, field));
    return check(values, target, reached, "The robot is at " + target + ": write another target.");
  }

  private static boolean isEqual(KrlStruct to, KrlStruct at, String field) {
    double distance =
        to.get(field).map(ReadValues::number).orElse(Double.NaN)
            - at.get(field).map(ReadValues::number).orElse(Double.NaN);
    return Math.abs(distance) <= REACHED;
  }

  private static Check command(ReadValues values) {
    return check(
        values,
        "JOV_COMMAND",
        values.text("JOV_COMMAND").equals("0"),
        "The program waits for a command: write the path, and last JOV_COMMAND.");
  }

  private static Check check(ReadValues values, String variable, boolean problem, String advice) {
    return new Check(
        "Variable that the program follows",
        values.get(variable) == null ? State.UNKNOWN : problem ? State.PROBLEM : State.OK,
        values.print(variable),
        problem ? advice : "");
  }
}
