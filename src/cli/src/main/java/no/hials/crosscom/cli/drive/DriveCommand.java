package no.hials.crosscom.cli.drive;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.recording.OutputException;
import no.hials.crosscom.cli.base.ControllerCommand;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.LiveLine;
import no.hials.crosscom.cli.base.LocalFiles;
import no.hials.crosscom.cli.base.Logging;
import no.hials.crosscom.cli.base.Robots;
import no.hials.crosscom.cli.base.StopSignal;
import no.hials.crosscom.cli.base.Terminal;
import no.hials.crosscom.cli.base.WriteOptions;
import no.hials.crosscom.control.ControlLoop;
import no.hials.crosscom.control.ControlRefusedException;
import no.hials.crosscom.control.DriveSpace;
import no.hials.crosscom.control.LoopConfig;
import no.hials.crosscom.control.LoopStatistics;
import no.hials.crosscom.control.Safety;
import no.hials.crosscom.control.State;
import no.hials.crosscom.control.StopReason;
import no.hials.crosscom.control.Trace;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.simulator.KrlPrograms;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code drive}. */
@Command(
    name = "drive",
    description = {
      "Moves the robot with the keyboard, a gamepad, a recording or another program.",
      "It moves a machine: a KRL program must run on the controller, and a person must stand at"
          + " the emergency stop."
    },
    footer = {
      "",
      "The controller must run actuator.src (base, tool) or ext_move_axis.src (joints), and"
          + " jov_sps.sub as the watchdog: see docs/how-to/drive-the-robot.md. With --mock the"
          + " simulated controller runs them.",
      "",
      "The robot moves only while input arrives and the dead-man is held: a repeating"
          + " key, a shoulder button of the gamepad, deadMan in a datagram, or dead_man in a"
          + " recording. The command ends with a message if the robot would come closer than 5"
          + " degrees to the end of an axis, leave 300 mm around its start (base, tool), or if"
          + " the operating mode changes.",
      "",
      "Keys:",
      "  w s, a d, r f   + and - of X, Y, Z (or A1, A2, A3; arrows and page keys too)",
      "  u j, i k, o l   + and - of A, B, C (or A4, A5, A6)",
      "  space           stop",
      "  + -             faster, slower",
      "  q               quit",
      "",
      "UDP: one JSON object per datagram, several times per second:",
      "  {\"axes\": [0.5, 0, 0], \"deadMan\": true}",
      "",
      "Exit code: 0 after a normal end, also by Ctrl-C (SIGINT) or SIGTERM, 1 if a limit or the"
          + " state of the controller stopped the robot, 4 if the connection or the device failed.",
      "",
      "Examples:",
      "  jopenshowvar drive --mock",
      "  jopenshowvar drive --host 172.31.1.147 --speed 10",
      "  jopenshowvar drive --mock --frame joints --device udp:7070 --record run.csv"
    })
public final class DriveCommand extends ControllerCommand {
  private static final long TICK_MILLIS = 50;
  private static final int RECORDED_CYCLES = 200_000;
  private static final double MAX_TURN = 60;
  private static final Duration SHORTEST_PERIOD = Duration.ofMillis(4);
  private static final Duration LONGEST_PERIOD = Duration.ofMillis(100);
  private static final Duration LONGEST_DELAY = Duration.ofSeconds(2);

  @Option(
      names = "--device",
      paramLabel = "DEVICE",
      converter = DriveDevice.Converter.class,
      description =
          "keyboard (default), gamepad, csv:FILE for a recording, or udp:PORT for datagrams (udp"
              + " alone: port 7070). Only this computer can send datagrams, unless a local"
              + " address is given: udp:ADDRESS:PORT. Then anyone who reaches that address can"
              + " move the robot.")
  private DriveDevice.@Nullable Choice device;

  @Option(
      names = "--frame",
      paramLabel = "FRAME",
      description =
          "The coordinates to move in: base (default) moves the tool along $BASE, tool along its"
              + " own axes, joints moves the axes of the robot.")
  private String frame = "base";

  @Option(
      names = "--speed",
      paramLabel = "SPEED",
      description =
          "Speed at full deflection: in mm/s, at most 250, default 25; with joints in degrees/s,"
              + " at most 60, default 5.")
  private @Nullable Double speed;

  @Option(
      names = "--turn",
      paramLabel = "SPEED",
      description =
          "Speed of rotations of the tool at full deflection, in degrees/s, at most"
              + " 60. Default: 5.")
  private @Nullable Double turn;

  @Option(
      names = "--dead-zone",
      paramLabel = "PART",
      description =
          "Deflection below which a stick counts as centred, from 0 to less than 1. Default:"
              + " 0.15 for a gamepad, 0 for other devices.")
  private @Nullable Double deadZone;

  @Option(
      names = "--period",
      paramLabel = "TIME",
      description = "Period of the commands, 4ms to 100ms. Default: 20ms.")
  private Duration period = Duration.ofMillis(20);

  @Option(
      names = "--max-delay",
      paramLabel = "TIME",
      description =
          "Maximum time to read the position of the robot, at most 2s. Default: 100ms. A longer"
              + " time ends the command, after the answer or after --timeout.")
  private Duration maxDelay = Duration.ofMillis(100);

  @Option(names = "--for", paramLabel = "TIME", description = "Stop after this time.")
  private @Nullable Duration length;

  @Option(
      names = "--record",
      paramLabel = "FILE",
      description =
          "Write a CSV file with the time, access times, target position, command and actual"
              + " position of each cycle, for the last 200000 cycles. An existing file needs"
              + " --yes.")
  private @Nullable Path record;

  @Option(
      names = "--no-watchdog",
      order = 5,
      description =
          "Drive without the watchdog on the controller. Then nothing stops the robot if this"
              + " program or the network fails.")
  private boolean noWatchdog;

  @Option(
      names = "--no-clock",
      order = 5,
      description =
          "Do not check the age of positions by the clock of the controller, $ROB_TIMER. Then old"
              + " answers of the server are noticed late.")
  private boolean noClock;

  @Option(
      names = "--takeover",
      order = 5,
      description =
          "Stop another client that drives the robot, and drive instead. Without it, nothing starts"
              + " while another client sends a heartbeat.")
  private boolean takeover;

  @Mixin private WriteOptions writeOptions = new WriteOptions();

  @Override
  public ExitCode run() throws IOException {
    DriveSpace space = space();
    double fullSpeed =
        checked("--speed", speed, space.usualSpeed(), space.maxSpeed(), space.unit());
    double fullTurn = turn(space);
    checkTimes();
    DriveDevice.Choice choice =
        device == null ? new DriveDevice.Converter().convert("keyboard") : device;
    double zone = zone(choice);
    if (record != null) {
      LocalFiles.checkNew(record, writeOptions.isYes());
    }
    Robot target = target();
    String what = "drive the robot by " + space.variable();
    writeOptions.permission(console()).checkAllowed(target, what);
    try (StopSignal stop = new StopSignal();
        RobotConnection controller = Robots.open(target, cfg -> cfg.reconnect(false))) {
      MockServer simulation = Robots.simulation(controller);
      if (simulation != null) {
        KrlPrograms.start(simulation.controller(), KrlPrograms.START, space.program());
      }
      // before the question, so that a change since then is not allowed
      OperatingMode mode = mode(controller);
      if (simulation == null) {
        writeOptions.permission(console()).check(controller, what);
      }
      try (DriveDevice opened = open(choice, zone, stop)) {
        Safety safety = safety(space, fullSpeed, fullTurn, mode);
        LoopConfig config =
            LoopConfig.create(
                cfg -> {
                  cfg.period(period)
                      .safety(safety)
                      .input(opened)
                      .duration(length == null ? Duration.ZERO : length)
                      .traceLength(record == null ? 1 : RECORDED_CYCLES);
                  if (takeover) {
                    cfg.takeover();
                  }
                });
        return drive(controller, config, space, fullSpeed, fullTurn, opened, stop);
      }
    }
  }

  private static DriveDevice open(DriveDevice.Choice choice, double zone, StopSignal stop)
      throws IOException {
    try {
      return choice.open(zone);
    } catch (IOException e) {
      stop.check(); // as a terminal cannot be taken any more after Ctrl-C
      throw e;
    }
  }

  // options

  private DriveSpace space() {
    return switch (frame.toLowerCase(Locale.ROOT)) {
      case "base" -> DriveSpace.BASE;
      case "tool" -> DriveSpace.TOOL;
      case "joints" -> DriveSpace.JOINTS;
      default -> throw wrongUsage("--frame must be base, tool or joints, is " + frame);
    };
  }

  private double checked(
      String option, @Nullable Double value, double usual, double most, String unit) {
    if (value == null) {
      return usual;
    }
    // the negation refuses NaN as well
    if (!(value > 0 && value <= most)) {
      throw wrongUsage(
          String.format(
              Locale.ROOT,
              "%s must be more than 0 and at most %.0f %s, is %s",
              option,
              most,
              unit,
              value));
    }
    return value;
  }

  private double turn(DriveSpace space) {
    if (turn != null && space == DriveSpace.JOINTS) {
      throw wrongUsage("--turn goes with base and tool; the speed of joints is --speed");
    }
    return checked("--turn", turn, DriveSpace.JOINTS.usualSpeed(), MAX_TURN, "deg/s");
  }

  private double zone(DriveDevice.Choice choice) {
    double zone = deadZone == null ? choice.usualDeadZone() : deadZone;
    if (!(zone >= 0 && zone < 1)) {
      throw wrongUsage("--dead-zone must be 0 to less than 1, is " + zone);
    }
    return zone;
  }

  private void checkTimes() {
    if (period.compareTo(SHORTEST_PERIOD) < 0 || period.compareTo(LONGEST_PERIOD) > 0) {
      throw wrongUsage("--period must be 4ms to 100ms, is " + period.toMillis() + "ms");
    }
    if (maxDelay.compareTo(LONGEST_DELAY) > 0) {
      throw wrongUsage("--max-delay must be at most 2s, is " + maxDelay.toMillis() + "ms");
    }
  }

  /** Returns the mode at the start; a later change ends the loop. */
  private static OperatingMode mode(RobotConnection controller) throws IOException {
    String mode = controller.client().readText("$MODE_OP").strip();
    for (OperatingMode known : OperatingMode.values()) {
      if (mode.equalsIgnoreCase("#" + known.constant())) {
        return known;
      }
    }
    return OperatingMode.T1; // the loop's own check tells what was found
  }

  private Safety safety(DriveSpace space, double full, double fullTurn, OperatingMode mode) {
    double seconds = period.toNanos() / 1e9;
    return Safety.create(
        cfg -> {
          cfg.modes(mode).maxFeedbackAge(maxDelay);
          if (space == DriveSpace.JOINTS) {
            cfg.axes(limit(30, full), limit(2, full * seconds), 15);
          } else {
            cfg.path(limit(100, full), limit(5, full * seconds), 50)
                .rotation(limit(30, fullTurn), limit(2, fullTurn * seconds), 15);
          }
          if (noWatchdog) {
            cfg.noWatchdog();
          }
          if (noClock) {
            cfg.noClock();
          }
        });
  }

  /** Raises the default limit to the requested value, with a margin for rounding. */
  private static double limit(double usual, double asked) {
    return Math.max(usual, 1.001 * asked);
  }

  // the loop

  private ExitCode drive(
      RobotConnection controller,
      LoopConfig config,
      DriveSpace space,
      double full,
      double fullTurn,
      DriveDevice opened,
      StopSignal stop)
      throws IOException {
    Logging.leaveOut(ControlLoop.class, isVerbose());
    console().hint(opened.greeting());
    try (ControlLoop loop =
        ControlLoop.start(controller.client(), config, space.law(State::input, full, fullTurn))) {
      StopReason reason;
      try (LiveLine line =
          new LiveLine(console().err(), !isVerbose() && Terminal.showsProgress())) {
        reason = await(loop, space, opened, stop, line);
      }
      console().print(summary(loop));
      if (loop.statistics().holding() == loop.statistics().cycles()) {
        console()
            .hint("the robot did not move: the dead-man was not held, or all input was too old");
      }
      if (!noWatchdog && reason.isPlanned()) {
        DriveEnd.hintOnWatchdog(read(controller, "JOV_LIMIT")).ifPresent(console()::hint);
      }
      if (!loop.toldToStand()) {
        console().error("could not send the stop command: the watchdog must stop the robot");
      }
      ExitCode code = ended(reason, controller, space);
      write(loop.trace()); // last: a full disk must not hide why the robot was stopped
      return code;
    } catch (ControlRefusedException e) {
      return ended(e.reason(), controller, space);
    }
  }

  /** Waits for the end, and ends the loop if the user stops it. */
  private StopReason await(
      ControlLoop loop, DriveSpace space, DriveDevice opened, StopSignal stop, LiveLine line) {
    while (true) {
      try {
        return loop.ended().get(TICK_MILLIS, TimeUnit.MILLISECONDS);
      } catch (TimeoutException e) {
        boolean standing = loop.status() == ControlLoop.Status.HOLDING;
        if (stop.isStopped() || opened.isEnded(standing)) {
          loop.stop();
        } else if (line.isDue()) {
          line.show(status(loop, space, opened));
        }
      } catch (InterruptedException e) {
        loop.close();
        Thread.currentThread().interrupt();
        return loop.stopReason().orElseThrow();
      } catch (ExecutionException e) {
        throw new AssertionError("completed by a reason only", e);
      }
    }
  }

  private static String status(ControlLoop loop, DriveSpace space, DriveDevice opened) {
    Optional<Trace.Cycle> last = loop.trace().last();
    if (last.isEmpty()) {
      return "starting";
    }
    LoopStatistics numbers = loop.statistics();
    boolean moving = loop.status() == ControlLoop.Status.MOVING;
    return String.format(
        Locale.ROOT,
        "%s | %s | %s | %.1f ms, missed %d",
        DriveText.shown(space, last.get().actual()),
        moving ? "moving" : "standing",
        moving ? DriveText.shown(space, opened.latest()) : "none",
        numbers.period().mean(),
        numbers.missed());
  }

  private static String summary(ControlLoop loop) {
    LoopStatistics numbers = loop.statistics();
    return String.format(
        Locale.ROOT,
        "%d cycles, %d of them standing, %d missed; period %.1f ms (99%%: %.1f), read %.1f ms,"
            + " write %.1f ms",
        numbers.cycles(),
        numbers.holding(),
        numbers.missed(),
        numbers.period().mean(),
        numbers.period().percentile99(),
        numbers.read().mean(),
        numbers.write().mean());
  }

  private void write(Trace trace) {
    if (record == null) {
      return;
    }
    try (Writer file = Files.newBufferedWriter(record)) {
      trace.writeCsv(file);
    } catch (IOException e) {
      throw new OutputException(record.toString(), e);
    }
  }

  private ExitCode ended(StopReason reason, RobotConnection controller, DriveSpace space) {
    ExitCode code = DriveEnd.code(reason);
    if (code == ExitCode.DONE) {
      console().print("stopped: " + reason.message());
    } else {
      console().error(reason.kind() + ": " + reason.message());
      DriveEnd.hints(reason, space, selected(controller)).forEach(console()::hint);
    }
    return code;
  }

  /** Returns the name of the robot's program, for a message; empty if it cannot be read. */
  private static String selected(RobotConnection controller) {
    return read(controller, "$PRO_NAME1[]").replace("\"", "").strip();
  }

  /** Reads a value for a message; returns an empty text if it cannot be read. */
  private static String read(RobotConnection controller, String name) {
    try {
      return controller.client().readText(name);
    } catch (IOException e) {
      return "";
    }
  }
}
