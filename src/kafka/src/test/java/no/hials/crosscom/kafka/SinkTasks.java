package no.hials.crosscom.kafka;

import java.time.Duration;

/** Creates tasks for tests of other packages. */
public final class SinkTasks {
  private SinkTasks() {}

  /** Returns a task that puts as few dead letters in one call as it can: 10. */
  public static RobotSinkTask reportingLittle() {
    return new RobotSinkTask(Duration.ZERO);
  }
}
