package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import no.hials.crosscom.cli.experiment.KrlPrograms;
import no.hials.crosscom.mock.MockServer;
import org.assertj.core.api.ThrowingConsumer;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** Drives the simulated robot with keys on a terminal, which {@code script} of util-linux makes. */
@Timeout(120)
@EnabledOnOs(OS.LINUX)
class DriveIT {
  private static final String READY = "q ends";

  @BeforeEach
  void needsATerminal() {
    assumeThat(PseudoTerminal.isAvailable()).isTrue();
  }

  /** The command on a terminal, between two looks at what the terminal is set to. */
  private static final class Terminal implements AutoCloseable {
    private final Process process;
    private final StringBuilder shown = new StringBuilder();

    Terminal(MockServer server, String... options) throws IOException {
      String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
      String command =
          "trap : INT; stty -a; '%s' -jar target/jopenshowvar.jar %s %s; echo code=$?; stty -a"
              .formatted(
                  java,
                  String.join(" ", Cli.argsOn(server, "drive", "--yes", "--no-watchdog")),
                  String.join(" ", options));
      ProcessBuilder builder = new ProcessBuilder("/usr/bin/script", "-qec", command, "/dev/null");
      builder.environment().keySet().removeAll(List.of("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS"));
      builder.environment().put("TERM", "xterm");
      builder.environment().put("SHELL", "/bin/sh");
      builder.redirectErrorStream(true);
      process = builder.start();
    }

    /** Reads on until a text is shown. */
    void await(String text) throws IOException {
      InputStream terminal = process.getInputStream();
      int from = shown.length();
      while (shown.indexOf(text, from) < 0) {
        int next = terminal.read();
        if (next < 0) {
          throw new AssertionError("it ended, and showed: " + shown);
        }
        shown.append((char) next);
      }
    }

    void press(String keys) throws IOException {
      try {
        process.getOutputStream().write(keys.getBytes(StandardCharsets.ISO_8859_1));
        process.getOutputStream().flush();
      } catch (IOException e) {
        throw new AssertionError("it takes no more keys, and showed: " + rest(), e);
      }
    }

    /** Gives the process of the command itself. */
    ProcessHandle command() {
      return process
          .descendants()
          .filter(each -> each.info().command().orElse("").endsWith("java"))
          .findAny()
          .orElseThrow();
    }

    /** Reads to the end, and gives all. */
    String rest() throws IOException {
      shown.append(
          new String(process.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1));
      return shown.toString();
    }

    /** Takes the terminal away from the command, as when its window is closed. */
    void hangUp() {
      process.destroyForcibly();
    }

    @Override
    public void close() {
      hangUp();
    }
  }

  /** Gives what {@code stty} shows twice, the same before and after. */
  private static void assertRestored(String shown) {
    List<String> settings =
        Pattern.compile("speed \\d+ baud.*?(?= extproc|-extproc)", Pattern.DOTALL)
            .matcher(shown)
            .results()
            // the number of the line discipline is not JLine's to restore
            .map(found -> found.group().replaceFirst("line = \\d+;", ""))
            .toList();
    assertThat(settings).as(shown).hasSize(2);
    assertThat(settings.get(1)).isEqualTo(settings.get(0));
    assertThat(settings.get(0)).contains(" icanon").contains(" echo ");
  }

  private static MockServer robot() throws IOException {
    MockServer server = MockServer.start(cfg -> {});
    KrlPrograms.start(server.controller(), KrlPrograms.START, DriveSpace.JOINTS.program);
    return server;
  }

  @Test
  void aHeldKeyMovesTheRobotAndItStandsWhenItIsLetGo() throws Exception {
    try (MockServer server = robot();
        Terminal terminal = new Terminal(server, "--frame=joints", "--max-delay=2s")) {
      terminal.await(READY);
      double start = server.controller().axes().a1();
      // as a keyboard repeats
      while (server.controller().axes().a1() < start + 1) {
        terminal.press("w");
        Thread.onSpinWait();
      }

      terminal.await("| standing | none |");
      while (!server.controller().standing()) {
        Thread.onSpinWait();
      }
      double stoodAt = server.controller().axes().a1();
      terminal.press("q");

      String shown = terminal.rest();
      assertThat(shown).contains("| moving | A1 +100% |", "stopped: the loop was asked to stop");
      assertThat(shown).contains("code=0");
      assertRestored(shown);
      assertThat(server.controller().axes().a1()).isEqualTo(stoodAt);
    }
  }

  /** Waits for the keys to be taken, and moves the third axis, so that there is what to stop. */
  private static void move(MockServer server, Terminal terminal) throws IOException {
    terminal.await(READY);
    double start = server.controller().axes().a3();
    while (server.controller().axes().a3() > start - 0.5) {
      terminal.press("f");
      Thread.onSpinWait();
    }
  }

  private static void assertToldToStand(MockServer server) {
    assertThat(Cli.runOn(server, "read", "MYAXIS").out()).containsPattern("A3 0(\\.0*)?,");
  }

  /** Moves the robot, and lets the command end. */
  private static void assertStopsTheRobotFirst(ThrowingConsumer<Terminal> end) throws IOException {
    try (MockServer server = robot();
        Terminal terminal = new Terminal(server, "--frame=joints", "--max-delay=2s")) {
      move(server, terminal);

      end.accept(terminal);

      String shown = terminal.rest();
      assertThat(shown).contains("stopped: the loop was asked to stop", "code=0");
      assertRestored(shown);
      assertToldToStand(server);
    }
  }

  @Test
  void ctrlCStopsTheRobotFirstAndLeavesTheTerminalAsItWas() throws Exception {
    assumeThat(PseudoTerminal.takesCtrlC()).isTrue();
    assertStopsTheRobotFirst(terminal -> terminal.press(PseudoTerminal.CTRL_C));
  }

  @Test
  void sigtermDoesTheSame() throws Exception {
    assertStopsTheRobotFirst(terminal -> terminal.command().destroy());
  }

  @Test
  void aTerminalThatIsClosedStopsTheRobot() throws Exception {
    try (MockServer server = robot();
        Terminal terminal = new Terminal(server, "--frame=joints", "--max-delay=2s")) {
      move(server, terminal);

      ProcessHandle command = terminal.command();
      terminal.hangUp();

      command.onExit().get(60, TimeUnit.SECONDS);
      assertToldToStand(server);
    }
  }

  @Test
  void theTerminalIsRestoredWhenALimitEndsIt() throws Exception {
    try (MockServer server = MockServer.start(cfg -> {});
        Terminal terminal = new Terminal(server)) {
      String shown = terminal.rest();

      assertThat(shown).contains("PROGRAM: $PRO_STATE1 must be #P_ACTIVE, is #P_FREE", "code=1");
      assertRestored(shown);
    }
  }
}
