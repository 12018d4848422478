package no.hials.crosscom.control;

import org.jspecify.annotations.Nullable;

/**
 * Why a loop has ended or did not start.
 *
 * @param kind what kind of reason
 * @param message which limit or rule, what was found and what is allowed
 * @param cause what was thrown, if something was
 */
public record StopReason(Kind kind, String message, @Nullable Throwable cause) {

  /** The kinds of reasons. */
  public enum Kind {
    /** Somebody stopped or closed the loop. */
    ASKED,
    /** The time that was asked for is over. */
    TIME_OVER,
    /** The law asked for a higher speed than is allowed, or the robot moves faster. */
    SPEED,
    /** The law asked for too long a way in one cycle. */
    STEP,
    /** An axis would be or is outside its limits less the margin. */
    AXIS_LIMIT,
    /** The tool would be or is outside the workspace less the margin. */
    WORKSPACE,
    /** The robot is too far from its target. */
    TRACKING_ERROR,
    /** The value that says where the robot is was too old when it came. */
    STALE_FEEDBACK,
    /** The robot was told to move, and the value that says where it is does not change. */
    STALLED_FEEDBACK,
    /** The operating mode is not among the allowed ones. */
    MODE,
    /** The robot's program does not run. */
    PROGRAM,
    /** The watchdog on the controller does not see the heartbeat, or is not set as it was. */
    WATCHDOG,
    /** The law threw an exception, or gave what is no command. */
    LAW,
    /** The input device threw an exception. */
    INPUT,
    /** A variable could not be read or written. */
    ACCESS,
    /** An error of the loop itself. */
    ERROR
  }

  StopReason(Kind kind, String message) {
    this(kind, message, null);
  }

  /**
   * Says whether the loop ended as it was asked to.
   *
   * @return true for {@link Kind#ASKED} and {@link Kind#TIME_OVER}
   */
  public boolean isPlanned() {
    return kind == Kind.ASKED || kind == Kind.TIME_OVER;
  }

  @Override
  public String toString() {
    return kind + ": " + message;
  }
}
