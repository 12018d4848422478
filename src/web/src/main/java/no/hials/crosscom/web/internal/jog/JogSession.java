package no.hials.crosscom.web.internal.jog;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import no.hials.crosscom.control.ControlLoop;
import no.hials.crosscom.control.ControlRefusedException;
import no.hials.crosscom.control.DriveSpace;
import no.hials.crosscom.control.LoopConfig;
import no.hials.crosscom.control.Safety;
import no.hials.crosscom.control.State;
import no.hials.crosscom.control.StopReason;
import no.hials.crosscom.control.input.Input;
import no.hials.crosscom.control.input.InputDevice;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.web.WebConfig;
import no.hials.crosscom.web.internal.robot.RobotSession;
import no.hials.crosscom.web.internal.socket.CommandException;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A control loop with which a page moves the robot. It runs from the start of jogging to its end,
 * and keeps the robot still while no button is held. The loop reads this input device in each
 * cycle; nothing here blocks it.
 *
 * <p>It uses the connection of the page, so that all readings of the robot are in one queue: a
 * reading that takes too long ends the loop, even if another view requested it.
 */
final class JogSession implements InputDevice {
  private static final Logger LOG = LoggerFactory.getLogger(JogSession.class);

  /** The limits of the loop: its defaults. A speed of 100 % is just below them. */
  private static final Safety LIMITS = Safety.create(cfg -> {});

  private static final double ROUNDING = 0.999;
  private static final Duration LATE = Duration.ofMillis(250);
  private static final String MODE = "$MODE_OP";
  private static final String STATE = "$PRO_STATE1";
  private static final String PROGRAM = "$PRO_NAME1[]";

  private final JogOwner.Person person;
  private final RobotSession robot;
  private final DriveSpace space;
  private final Jogs jogs;
  private final Supplier<String> refusal;
  private final HoldToRun holds;

  /** The positions at the beginning of the holds. */
  private final Map<Long, String> before = new ConcurrentHashMap<>();

  private volatile @Nullable ControlLoop loop;
  private volatile @Nullable String stopped;
  private volatile long seen;

  /** When the loop last read this device, by {@link System#nanoTime}. */
  private volatile long cycled = System.nanoTime();

  // used by the loop only
  private List<Press> presses = List.of();
  private final @Nullable JogStep[] steps = new JogStep[HoldToRun.DIRECTIONS];

  /** Receives the ends of holds. */
  interface Jogs {
    /**
     * Called when a hold is over, by any thread; must not block.
     *
     * @param name the direction, such as {@code X+}
     * @param before the position at the beginning
     */
    void ended(JogSession session, String name, String before, String reason);
  }

  private JogSession(
      JogOwner.Person person,
      RobotSession robot,
      DriveSpace space,
      Jogs jogs,
      Supplier<String> refusal) {
    this.person = person;
    this.robot = robot;
    this.space = space;
    this.jogs = jogs;
    this.refusal = refusal;
    holds = new HoldToRun(System::nanoTime, this::ended);
    seen = System.nanoTime();
  }

  /**
   * Checks the robot and starts the loop, which takes up to a second or two.
   *
   * @param refusal returns why the page may not jog any more; empty if it may
   * @throws IOException if the robot is not ready; the message is a sentence for people
   */
  static JogSession open(
      JogOwner.Person person,
      RobotSession robot,
      DriveSpace space,
      WebConfig options,
      Jogs jogs,
      Supplier<String> refusal)
      throws IOException {
    OperatingMode mode = checkMode(robot, options.jogInAuto() || robot.simulation().isPresent());
    checkProgram(robot, space);
    JogSession session = new JogSession(person, robot, space, jogs, refusal);
    LoopConfig config =
        LoopConfig.create(
            cfg ->
                cfg.safety(
                        limits ->
                            limits
                                .modes(mode)
                                .maxInputAge(HoldToRun.SILENCE)
                                .maxFeedbackAge(options.jogMaxDelay()))
                    .input(session)
                    .writeIf(session::mayWrite)
                    .traceLength(1));
    try {
      ControlLoop started =
          ControlLoop.start(
              robot.client(),
              config,
              space.law(session::deflections, fullSpeed(space), fullTurn()));
      session.loop = started;
      if (session.stopped != null) {
        started.stop();
      }
      return session;
    } catch (ControlRefusedException e) {
      String why = session.stopped;
      throw new CommandException(why == null ? e.reason().message() : "did not jog: " + why);
    }
  }

  private static OperatingMode checkMode(RobotSession robot, boolean inAnyMode) throws IOException {
    String found = robot.client().readText(MODE).strip();
    for (OperatingMode mode : OperatingMode.values()) {
      if (found.equalsIgnoreCase("#" + mode.constant())
          && (inAnyMode || mode == OperatingMode.T1)) {
        return mode;
      }
    }
    throw new CommandException(
        MODE
            + " must be #T1, is "
            + found
            + (inAnyMode
                ? ""
                : "; other modes need the option --jog-in-auto of the page's server"));
  }

  private static void checkProgram(RobotSession robot, DriveSpace space) throws IOException {
    String name = space.program().toUpperCase(Locale.ROOT);
    String advice = "; select and start " + name + " (krl/" + space.program() + ".src)";
    String running = "#" + ProgramState.ACTIVE.constant();
    String state = robot.client().readText(STATE).strip();
    if (!state.equalsIgnoreCase(running)) {
      throw new CommandException(STATE + " must be " + running + ", is " + state + advice);
    }
    String found = robot.client().readText(PROGRAM).replace("\"", "").strip();
    if (!found.equalsIgnoreCase(name)) {
      throw new CommandException(PROGRAM + " must be " + name + ", is " + found + advice);
    }
  }

  /** Returns the full speed of a straight motion or an axis, mm/s or degrees/s. */
  static double fullSpeed(DriveSpace space) {
    return ROUNDING * (space == DriveSpace.JOINTS ? LIMITS.axes() : LIMITS.path()).speed();
  }

  /** Returns the full speed of a rotation of the tool, degrees/s. */
  static double fullTurn() {
    return ROUNDING * LIMITS.rotation().speed();
  }

  /** Returns the page that moves the robot. */
  JogOwner.Person person() {
    return person;
  }

  /** Returns the robot. */
  RobotSession robot() {
    return robot;
  }

  /** Returns the coordinates in which it moves. */
  DriveSpace space() {
    return space;
  }

  /** Called when the page shows that it is there. */
  void see() {
    seen = System.nanoTime();
  }

  /** Begins a hold; see {@link HoldToRun#press}. */
  long press(Press press) throws CommandException {
    boolean added = before.putIfAbsent(press.id(), position()) == null;
    try {
      return holds.press(press);
    } catch (CommandException e) {
      if (added) {
        before.remove(press.id());
      }
      throw e;
    }
  }

  /** Continues a hold; see {@link HoldToRun#beat}. */
  long beat(long id, long number, long mark) throws CommandException {
    return holds.beat(id, number, mark);
  }

  /** Ends a hold. */
  void release(long id) {
    holds.release(id);
  }

  /** Returns whether the loop waits for the robot, whose state is unknown meanwhile. */
  boolean isLate() {
    return loop != null && System.nanoTime() - cycled > LATE.toNanos();
  }

  /** Returns whether the last cycle moved the robot. */
  boolean isMoving() {
    ControlLoop running = loop;
    return running != null
        && !isLate()
        && running.stopReason().isEmpty()
        && running.trace().last().filter(it -> it.moving()).isPresent();
  }

  /** Ends all motion and the loop, without waiting. */
  void stop(String reason) {
    if (stopped == null) {
      stopped = reason;
    }
    holds.stop(reason);
    ControlLoop running = loop;
    if (running != null) {
      running.stop();
    }
  }

  /** Ends all motion and the loop, and waits until the stop was sent to the robot. */
  void close(String reason) {
    stop(reason);
    ControlLoop running = loop;
    if (running != null) {
      running.close();
    }
  }

  /** Returns a future that is completed by the reason when the loop has ended. */
  CompletableFuture<String> ended() {
    ControlLoop running = loop;
    if (running == null) {
      throw new IllegalStateException("the loop has not started");
    }
    return running.ended().thenApply(this::ended);
  }

  private String ended(StopReason reason) {
    holds.stop(reason.message());
    String why = stopped;
    ControlLoop running = loop;
    boolean told = running == null || running.toldToStand();
    return (reason.isPlanned() && why != null ? why : reason.message())
        + (told ? "" : "; the robot could not be told to stand: the watchdog must stop it");
  }

  private void ended(Press press, String reason) {
    String name = space.names().get(press.direction()) + (press.positive() ? "+" : "-");
    String begin = before.remove(press.id());
    jogs.ended(this, name, begin == null ? "" : begin, reason);
  }

  /** Returns the last position that the loop read, as KRL text; empty before its first cycle. */
  String position() {
    ControlLoop running = loop;
    StringBuilder text = new StringBuilder();
    if (running != null) {
      running
          .trace()
          .last()
          .ifPresent(
              cycle -> {
                for (int i = 0; i < HoldToRun.DIRECTIONS; i++) {
                  text.append(i == 0 ? "{" : ",")
                      .append(
                          String.format(
                              Locale.ROOT, "%s %.3f", space.names().get(i), cycle.actual().get(i)));
                }
                text.append('}');
              });
    }
    return text.toString();
  }

  /**
   * Returns the position after a hold, as KRL text; empty if it cannot be read. Waits for the robot
   * if the loop no longer reads the position.
   */
  String positionAfter() {
    ControlLoop running = loop;
    if (running != null && running.stopReason().isEmpty() && !isLate()) {
      return position();
    }
    try {
      return robot.client().readText(space == DriveSpace.JOINTS ? "$AXIS_ACT" : "$POS_ACT");
    } catch (IOException e) {
      LOG.debug("the position after a hold is not known", e);
      return "";
    }
  }

  // the loop

  @Override
  public Input read() {
    cycled = System.nanoTime();
    if (mayWrite() && System.nanoTime() - seen > JogOwner.PRESENCE.toNanos()) {
      stop("the page of " + person.name() + " is gone");
    }
    HoldToRun.Allowed allowed = holds.allowed();
    if (allowed == null) {
      presses = List.of();
      return Input.NONE;
    }
    presses = allowed.presses();
    return new Input(List.of(), List.of(), true, allowed.nanoTime());
  }

  /** Returns whether the loop may still write; otherwise it ends. */
  private boolean mayWrite() {
    String why = refusal.get();
    if (!why.isEmpty()) {
      stop(why);
    }
    return why.isEmpty();
  }

  private Input deflections(State state) {
    Double[] axes = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    for (Press press : presses) {
      axes[press.direction()] =
          press.signed(press.step() == 0 ? press.speed() : step(press, state));
    }
    Input input = state.input();
    return new Input(List.of(axes), input.buttons(), input.deadMan(), input.nanoTime());
  }

  /** Returns the deflection of a press that has a step, and ends the hold after it. */
  private double step(Press press, State state) {
    JogStep step = steps[press.direction()];
    if (step == null || step.press().id() != press.id()) {
      step = new JogStep(space, press, state);
      steps[press.direction()] = step;
    }
    boolean turns = space != DriveSpace.JOINTS && press.direction() > 2;
    double deflection = step.deflection(state, turns ? fullTurn() : fullSpeed(space));
    if (deflection == 0) {
      holds.finish(press.id());
    }
    return deflection;
  }
}
