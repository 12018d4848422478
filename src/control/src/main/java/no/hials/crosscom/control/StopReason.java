package no.hials.crosscom.control;

import org.jspecify.annotations.Nullable;

/**
 * The reason why a loop has ended or did not start.
 *
 * @param kind the kind of reason
 * @param message the limit or rule, with the actual and the allowed value
 * @param cause the exception, if there was one
 */
public record StopReason(StopKind kind, String message, @Nullable Throwable cause) {

  /** The kinds of reasons. */
  public enum StopKind {
    /** The loop was stopped or closed. */
    ASKED,
    /** The configured time is over. */
    TIME_OVER,
    /** The law commanded a speed above the limit, or the robot moves faster. */
    SPEED,
    /** The law commanded too large a step in one cycle. */
    STEP,
    /** An axis is outside its limits, or would be outside its limits minus the margin. */
    AXIS_LIMIT,
    /** A5 is too near 0 for a Cartesian law: a singularity of the wrist. */
    SINGULARITY,
    /** The tool is outside the workspace, or would be outside the workspace minus the margin. */
    WORKSPACE,
    /** The robot is too far from its target. */
    TRACKING_ERROR,
    /** The position of the robot was too old when it was read, or its age is not known. */
    STALE_FEEDBACK,
    /** The robot was told to move, and its position does not change. */
    STALLED_FEEDBACK,
    /** The operating mode is not allowed. */
    MODE,
    /** The robot program is not running. */
    PROGRAM,
    /** The watchdog on the controller does not see the heartbeat, or its setting has changed. */
    WATCHDOG,
    /** The loop could not send the next heartbeat in the time of the watchdog. */
    LATE_HEARTBEAT,
    /** Another client sends a heartbeat, so it moves the robot. */
    OTHER_DRIVER,
    /** The law threw an exception or returned an invalid command. */
    LAW,
    /** The input device threw an exception. */
    INPUT,
    /** A variable could not be read or written. */
    ACCESS,
    /** An error of the loop itself. */
    ERROR
  }

  StopReason(StopKind kind, String message) {
    this(kind, message, null);
  }

  /**
   * Returns whether the loop ended as planned: true for {@link StopKind#ASKED} and {@link
   * StopKind#TIME_OVER}.
   */
  public boolean isPlanned() {
    return kind == StopKind.ASKED || kind == StopKind.TIME_OVER;
  }

  @Override
  public String toString() {
    return kind + ": " + message;
  }
}
