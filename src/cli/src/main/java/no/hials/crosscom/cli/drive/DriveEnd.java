package no.hials.crosscom.cli.drive;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.control.DriveSpace;
import no.hials.crosscom.control.StopReason;

/** The end of a control loop for the user: the exit code and the remedies. */
final class DriveEnd {
  private static final String PAGE = "see docs/how-to/drive-the-robot.md";

  private DriveEnd() {}

  static ExitCode code(StopReason reason) {
    return switch (reason.kind()) {
      case ASKED, TIME_OVER -> ExitCode.DONE;
      case STALE_FEEDBACK, INPUT -> ExitCode.LOST;
      case ACCESS ->
          cause(reason) instanceof CrossComException failed
              ? ExitCode.of(failed)
              : ExitCode.REFUSED;
      case LAW, ERROR -> ExitCode.INTERNAL_ERROR;
      case SPEED,
          STEP,
          AXIS_LIMIT,
          SINGULARITY,
          WORKSPACE,
          TRACKING_ERROR,
          STALLED_FEEDBACK,
          MODE,
          PROGRAM,
          WATCHDOG,
          LATE_HEARTBEAT,
          OTHER_DRIVER ->
          ExitCode.REFUSED;
    };
  }

  /** Finds the exception of the client. */
  private static Throwable cause(StopReason reason) {
    Throwable cause = reason.cause();
    while (cause != null && !(cause instanceof CrossComException) && cause.getCause() != null) {
      cause = cause.getCause();
    }
    return cause == null ? new IllegalStateException(reason.message()) : cause;
  }

  /**
   * Returns lines of advice.
   *
   * @param selected the name of the program that is selected on the controller; empty if unknown
   */
  static List<String> hints(StopReason reason, DriveSpace space, String selected) {
    String program = space.program().toUpperCase(java.util.Locale.ROOT);
    List<String> hints = new ArrayList<>();
    switch (reason.kind()) {
      case PROGRAM, STALLED_FEEDBACK -> {
        hints.add(
            "the robot moves only if a program on the controller follows " + space.variable());
        hints.add(
            selected(selected)
                + "; select and start "
                + program
                + " (krl/"
                + space.program()
                + ".src), and switch the drives on");
      }
      case WATCHDOG -> {
        hints.add(
            "the watchdog stops the robot if this program or the network fails; it needs the"
                + " variables of krl/config.dat, and krl/jov_sps.sub in the submit interpreter");
        hints.add("without it, --no-watchdog drives at your own risk");
      }
      case LATE_HEARTBEAT ->
          hints.add(
              "this computer was asleep or too busy; start the program on the controller again");
      case STALE_FEEDBACK ->
          hints.add(
              "--max-delay allows older positions; --no-clock does not compare them with the clock"
                  + " of the controller");
      case OTHER_DRIVER ->
          hints.add(
              "two drivers would move one robot: end the other one; --takeover stops it, if it is a"
                  + " control loop of this library");
      case MODE -> hints.add("the operating mode changed; start again in the new mode");
      case ACCESS -> {
        if (cause(reason) instanceof CrossComAccessException) {
          hints.add(
              "the controller must have the variable "
                  + space.variable()
                  + " (krl/config.dat), and "
                  + program
                  + " (krl/"
                  + space.program()
                  + ".src) must follow it");
        }
      }
      case WORKSPACE ->
          hints.add(
              "start again at the current position, which becomes the centre"
                  + " of the workspace");
      default -> {
        // its message says all
      }
    }
    if (!hints.isEmpty() && reason.kind() != StopReason.StopKind.MODE) {
      hints.add(PAGE + "; without a controller, try --mock");
    }
    return hints;
  }

  /**
   * Returns a hint if the watchdog is on after a planned end.
   *
   * @param limit its setting as text; empty if unknown
   */
  static Optional<String> hintOnWatchdog(String limit) {
    return limit.isBlank() || limit.equals("0")
        ? Optional.empty()
        : Optional.of(
            "the watchdog was already on (JOV_LIMIT is "
                + limit
                + "), for example after a failure; it stays on and stops the program now: write"
                + " 0 to JOV_LIMIT and start the program again");
  }

  private static String selected(String name) {
    return name.isBlank() ? "no program is selected there" : name + " is selected there";
  }
}
