package no.hials.crosscom.cli.krl;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cli.base.ConsoleCommand;
import no.hials.crosscom.cli.base.Converters;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.LoadedFiles;
import no.hials.crosscom.cli.base.MessageFeed;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.Message;
import no.hials.crosscom.simulator.MotionTarget;
import no.hials.crosscom.simulator.SimulationClock;
import no.hials.crosscom.simulator.VariableTable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code krl run}. */
@Command(
    name = "run",
    description = {
      "Runs a program to its end on a simulated controller, and prints where the robot went.",
      "The simulated time passes as fast as possible. Start is pressed again when the program"
          + " halts without a message that stops it. Messages of the program are confirmed, and"
          + " each dialogue is answered by its first key; stderr has the messages and answers."
    },
    footer = {
      "",
      "The output is CSV. Each motion is a row: the time of its start in seconds, its target in"
          + " $BASE, in mm and degrees, and the axes there, with the external axes that exist."
          + " A spline block has a row for each point, with the time of the start of the block."
          + " With --period a row is a position instead.",
      "",
      "Exit code 1 if the program does not reach its end; stderr has the messages.",
      "",
      "Examples:",
      "  jopenshowvar krl run place.src --archive cell.zip",
      "  jopenshowvar krl run place.src --period 12ms > path.csv"
    })
final class KrlRun extends ConsoleCommand {
  private static final Duration CYCLE = Duration.ofMillis(12);
  private static final List<String> POSITION = List.of("X", "Y", "Z", "A", "B", "C");
  private static final int ROBOT_AXES = 6;

  @Parameters(paramLabel = "FILE.src", description = "The program, or one of --archive.")
  private Path file = Path.of("");

  @Option(
      names = "--archive",
      paramLabel = "PATH",
      description = "Load the archive of a controller first, a zip or a folder.")
  private @Nullable Path archive;

  @Option(
      names = "--config",
      paramLabel = "FILE.dat",
      description = "Load a data list before the program. Can be repeated.")
  private List<Path> configs = new ArrayList<>();

  @Option(
      names = "--robot",
      paramLabel = "NAME",
      description =
          "The robot, such as \"KR 210 R2700-2\"; machine data of --archive replace it. Default:"
              + " \"KR 6 R900 sixx\".")
  private @Nullable String robot;

  @Option(
      names = "--mode",
      paramLabel = "MODE",
      converter = Converters.Mode.class,
      description = "Operating mode: T1, T2, AUT (default) or EXT.")
  private OperatingMode mode = OperatingMode.AUT;

  @Option(
      names = "--period",
      paramLabel = "TIME",
      description = "Print the position at this period, a multiple of 12 ms, not the motions.")
  private @Nullable Duration period;

  @Option(
      names = "--limit",
      paramLabel = "TIME",
      description = "The longest simulated time. Default: 1h.")
  private Duration limit = Duration.ofHours(1);

  @Option(names = "--strict", description = "End with an error if a file has one.")
  private boolean strict;

  /** The state message while a BCO run is due, as before every program. */
  private static final int COINCIDENCE_DUE = 309;

  private List<String> axes = List.of();

  @Override
  public ExitCode run() throws IOException {
    if (period != null && period.toMillis() % CYCLE.toMillis() != 0) {
      throw wrongUsage("--period must be a multiple of 12 ms, is " + period.toMillis() + " ms");
    }
    RobotModel model = model(robot);
    LoadedFiles loaded = new LoadedFiles(strict);
    try (Controller controller =
        new Controller(VariableTable.krc4(model), SimulationClock.stepped(), model, "krl-run")) {
      String program = load(controller, loaded);
      loaded.check(controller);
      loaded.warnings().forEach(console()::hint);
      controller.setMode(mode);
      try {
        controller.robot().select(program);
      } catch (KrlFileException e) {
        throw new FileException(
            file + " cannot be selected:", String.valueOf(e.getMessage()).lines().toList(), e);
      }
      axes = axes(controller);
      console().print(String.join(",", titles()));
      MessageFeed messages = new MessageFeed(controller);
      boolean ended = runToEnd(controller, messages);
      show(messages);
      if (!ended) {
        console().error("the program did not reach its end: " + controller);
      }
      return ended ? ExitCode.DONE : ExitCode.REFUSED;
    }
  }

  private String load(Controller controller, LoadedFiles loaded) throws FileException {
    if (archive != null) {
      loaded.add(controller.load(LoadedFiles.open(List.of(archive)), loaded.mode()));
    }
    for (Path config : configs) {
      loaded.load(controller, config);
    }
    return loaded.loadOrFind(controller, file, archive != null);
  }

  private boolean runToEnd(Controller controller, MessageFeed messages) {
    long rowCycles = period == null ? 1 : period.dividedBy(CYCLE);
    long cycles = limit.dividedBy(CYCLE);
    for (long cycle = 0; cycle < cycles; cycle++) {
      ProgramState state = controller.robot().state();
      if (state == ProgramState.END && controller.standing()) {
        return true;
      }
      if (state == ProgramState.RESET || state == ProgramState.STOP) {
        try {
          controller.runProgram();
        } catch (IllegalStateException e) {
          // after a message that stops the program, the messages say enough
          if (controller.variables().get("$STOPMESS").equals("FALSE")) {
            console().hint("not started: " + e.getMessage());
          }
          return false;
        }
      }
      if (period != null && cycle % rowCycles == 0) {
        print(controller, names().map(controller.variables()::get));
      }
      controller.step(CYCLE);
      show(messages);
      operate(controller);
      if (period == null) {
        controller.startedMotions().forEach(motion -> print(controller, values(motion)));
      }
    }
    console().hint("the simulated time of --limit is over" + waitsFor(controller));
    return false;
  }

  private void show(MessageFeed messages) {
    for (Message message : messages.poll()) {
      if (message.kind() != Message.Kind.STATUS || message.number() != COINCIDENCE_DUE) {
        console().hint(MessageFeed.text(message));
      }
    }
  }

  /** Answers dialogues, and confirms messages of a program that waits for it. */
  private void operate(Controller controller) {
    Optional<Message> dialogue = controller.dialogue();
    if (dialogue.isPresent()) {
      List<String> keys = dialogue.get().keys();
      int key = 1;
      while (keys.get(key - 1).isEmpty()) {
        key++;
      }
      controller.answer(dialogue.get(), key);
      console().hint("answered: " + key + " " + keys.get(key - 1));
    }
    // an error has stopped the program, and stays
    if (controller.robot().state() == ProgramState.ACTIVE
        && controller.variables().get("$STOPMESS").equals("TRUE")) {
      console().hint("confirmed messages: " + controller.confirmAll());
    }
  }

  private static String waitsFor(Controller controller) {
    return controller.robot().waitsForCondition()
        ? "; the program waits for a condition (WAIT FOR): " + controller.robot()
        : "";
  }

  /** Returns the fields of the robot's axes and of the external axes that exist. */
  private static List<String> axes(Controller controller) {
    int external = Math.min(Integer.parseInt(controller.variables().get("$EX_AX_NUM")), 6);
    return Stream.concat(
            IntStream.rangeClosed(1, ROBOT_AXES).mapToObj(axis -> "A" + axis),
            IntStream.rangeClosed(1, external).mapToObj(axis -> "E" + axis))
        .toList();
  }

  private List<String> titles() {
    return Stream.concat(Stream.of("time"), names()).toList();
  }

  private Stream<String> names() {
    String kind = period == null ? "FOR" : "ACT";
    return Stream.concat(
        POSITION.stream().map(field -> "$POS_" + kind + "." + field),
        axes.stream().map(field -> "$AXIS_" + kind + "." + field));
  }

  private Stream<String> values(MotionTarget motion) {
    return Stream.concat(values(motion.position(), POSITION), values(motion.axes(), axes));
  }

  private static Stream<String> values(KrlStruct struct, List<String> fields) {
    return fields.stream().map(field -> struct.get(field).orElseThrow().print());
  }

  private void print(Controller controller, Stream<String> values) {
    String time = String.format(Locale.ROOT, "%.3f", controller.time().toMillis() / 1000.0);
    console().print(Stream.concat(Stream.of(time), values).collect(Collectors.joining(",")));
  }
}
