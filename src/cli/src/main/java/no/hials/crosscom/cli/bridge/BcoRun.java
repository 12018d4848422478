package no.hials.crosscom.cli.bridge;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.time.Duration;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.protocol.code.Interpreter;

/** Presses Start again at the end of the BCO run, the first motion of a selected program. */
final class BcoRun {
  /** The time in which a program reaches its first motion. */
  private static final Duration BEGIN = Duration.ofMillis(500);

  private static final Duration LONGEST = Duration.ofMinutes(2);
  private static final Duration PERIOD = Duration.ofMillis(40);

  private BcoRun() {}

  /**
   * Waits for the end of the BCO run, and starts the program once more. Does nothing if the program
   * has no first motion soon, or has stopped for another reason. A BCO run to where the robot
   * stands is over before it can be seen, so a stop on the path is its end too; in EXT there is
   * none.
   */
  static void complete(CrossComClient client) throws IOException {
    if (await(client, "FALSE", BEGIN) || await(client, "TRUE", LONGEST)) {
      return;
    }
    if (client.readText("$PRO_STATE1").equals("#P_STOP")
        && client.readText("$ON_PATH").equals("TRUE")
        && client.readText("$STOPMESS").equals("FALSE")
        && !client.readText("$MODE_OP").equals("#EX")) {
      client.programs().start(Interpreter.ROBOT);
    }
  }

  /**
   * Waits while {@code $MOVE_BCO} has a value and the program is active; returns whether it still
   * is after the time.
   */
  private static boolean await(CrossComClient client, String value, Duration limit)
      throws IOException {
    long end = System.nanoTime() + limit.toNanos();
    while (client.readText("$PRO_STATE1").equals("#P_ACTIVE")) {
      if (!client.readText("$MOVE_BCO").equals(value)) {
        return false;
      }
      if (System.nanoTime() >= end) {
        return true;
      }
      try {
        Thread.sleep(PERIOD.toMillis());
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new InterruptedIOException("interrupted during the BCO run");
      }
    }
    return false;
  }
}
