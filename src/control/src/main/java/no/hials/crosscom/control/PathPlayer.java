package no.hials.crosscom.control;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.KRL.structs.KRLAxis;
import no.hials.crosscom.KRL.structs.KRLPos;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;

/**
 * Writes a path into an array of the controller and lets {@code krl/play_path.src} execute it.
 *
 * <p><b>It moves a machine</b>, at the speed in {@code JOV_SPEED}; the robot moves to the first
 * point with a PTP motion. Every point is checked against the limits of {@link Safety} for the axes
 * and the tool, and the mode, the program, the watchdog, and that no other client sends a heartbeat
 * are checked before the motion starts. The limits of speed and step do not apply. The player sends
 * the heartbeat while it waits for the end, so the robot stops if the connection is lost.
 *
 * <p>Not thread-safe. It starts no thread.
 */
public final class PathPlayer {
  /** The length of the arrays in {@code krl/config.dat}. */
  public static final int MAX_POINTS = 50;

  private static final int AXES = 1;
  private static final int POSITIONS = 2;
  private static final int BUSY = 0;
  private static final int DONE = 1;
  private static final int REFUSED = 2;
  private static final Duration SHORTEST_LIMIT = Duration.ofMillis(1);
  private static final Duration LONGEST_LIMIT = Duration.ofDays(1);
  private static final Duration READY_TIME = Duration.ofSeconds(5);
  private static final long PAUSE = Duration.ofMillis(20).toNanos();

  private final Channel channel;
  private final Safety safety;
  private final LoopTime time;

  /**
   * Creates a player.
   *
   * @param client the connection to the controller that runs {@code PLAY_PATH}
   * @param safety the limits
   */
  public PathPlayer(CrossComClient client, Safety safety) {
    this(client, safety, LoopTime.REAL);
  }

  PathPlayer(CrossComClient client, Safety safety, LoopTime time) {
    this.channel = new Channel(client);
    this.safety = safety;
    this.time = time;
  }

  /**
   * Plays a path of axis positions (PTP, approximated) and waits for its end.
   *
   * @param points 1 to 50 points, degrees
   * @param limit the time limit of the motion, 1 ms to 1 day; after that the heartbeat ends, and
   *     the watchdog stops the robot
   * @throws ControlRefusedException if a limit is violated, in which case no motion was written, or
   *     if the motion did not finish
   * @throws InterruptedException if the wait was interrupted; the watchdog stops the robot
   */
  public void playAxes(List<Axis> points, Duration limit)
      throws ControlRefusedException, InterruptedException {
    check(points, limit);
    Guard guard = Preflight.check(channel, safety, false);
    List<KRLVariable> variables = new ArrayList<>();
    for (Axis point : points) {
      guard.check(point, false);
      KRLAxis variable = new KRLAxis("JOV_PATH_AXIS[" + (variables.size() + 1) + "]");
      variable.setValue(point);
      variables.add(variable);
    }
    play(AXES, variables, limit);
  }

  /**
   * Plays a path of the tool (straight lines, approximated) and waits for its end. The arm keeps
   * its Status and Turn up to the first point.
   *
   * @param points 1 to 50 points in {@code $BASE}
   * @param limit the time limit of the motion, 1 ms to 1 day; after that the heartbeat ends, and
   *     the watchdog stops the robot
   * @throws ControlRefusedException if a limit is violated, in which case no motion was written, or
   *     if the motion did not finish
   * @throws InterruptedException if the wait was interrupted; the watchdog stops the robot
   */
  public void playPositions(List<Frame> points, Duration limit)
      throws ControlRefusedException, InterruptedException {
    check(points, limit);
    Guard guard = Preflight.check(channel, safety, true);
    List<KRLVariable> variables = new ArrayList<>();
    for (Frame point : points) {
      guard.check(point, false);
      KRLPos variable = new KRLPos("JOV_PATH_POS[" + (variables.size() + 1) + "]");
      variable.setValue(point);
      variable.setS(channel.position.getS());
      variable.setT(channel.position.getT());
      variables.add(variable);
    }
    play(POSITIONS, variables, limit);
  }

  private static void check(List<?> points, Duration limit) {
    Checks.between("time limit of the motion", limit, SHORTEST_LIMIT, LONGEST_LIMIT);
    Checks.holds(
        !points.isEmpty() && points.size() <= MAX_POINTS,
        "a path must have 1 to " + MAX_POINTS + " points, has " + points.size());
  }

  private void play(int command, List<KRLVariable> points, Duration limit)
      throws ControlRefusedException, InterruptedException {
    Heartbeat heartbeat = new Heartbeat(channel, time, safety.watchdog());
    heartbeat.observe();
    heartbeat.checkAlone(false);
    heartbeat.start();
    boolean done = false;
    try {
      await(heartbeat, READY_TIME, "PLAY_PATH must be ready");
      for (KRLVariable point : points) {
        beat(heartbeat);
        channel.write(point);
      }
      channel.writeInt("JOV_COUNT", points.size());
      channel.writeInt("JOV_RESULT", BUSY);
      channel.writeInt("JOV_COMMAND", command); // last, since it starts the motion
      int result = await(heartbeat, limit, "the path must end");
      done = result == DONE;
      if (!done) {
        throw new ControlRefusedException(
            StopKind.PROGRAM,
            "the result of PLAY_PATH must be "
                + DONE
                + " (done), is "
                + result
                + (result == REFUSED ? " (refused)" : ""));
      }
    } finally {
      if (done) {
        heartbeat.end();
      }
    }
  }

  private void beat(Heartbeat heartbeat) throws ControlRefusedException {
    if (heartbeat.isDue()) {
      channel.write(heartbeat.next());
    }
  }

  /** Waits for a result of the program. */
  private int await(Heartbeat heartbeat, Duration limit, String what)
      throws ControlRefusedException, InterruptedException {
    KRLInt result = new KRLInt("JOV_RESULT");
    long end = time.nanoTime() + limit.toNanos();
    while (true) {
      beat(heartbeat);
      channel.read(List.of(result, channel.program));
      channel.checkProgram();
      if (result.intValue() != BUSY) {
        return result.intValue();
      }
      long now = time.nanoTime();
      if (now > end) {
        throw new ControlRefusedException(
            StopKind.PROGRAM, what + " within " + limit + ", JOV_RESULT is still " + BUSY);
      }
      if (Thread.interrupted()) {
        throw new InterruptedException("interrupted while waiting: " + what);
      }
      time.awaitUntil(now + PAUSE);
    }
  }
}
