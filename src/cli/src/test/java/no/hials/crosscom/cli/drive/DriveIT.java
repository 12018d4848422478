package no.hials.crosscom.cli.drive;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.PseudoTerminal;
import no.hials.crosscom.control.DriveSpace;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.simulator.KrlPrograms;
import org.assertj.core.api.ThrowingConsumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** Drives the simulated robot with keys on a terminal, which {@code script} of util-linux makes. */
@Timeout(120)
@EnabledOnOs(OS.LINUX)
class DriveIT {
  private static final String READY = "q ends";

  /** Starts the command, between two looks at what the terminal is set to. */
  private static PseudoTerminal drive(MockServer server, String... options) throws IOException {
    return PseudoTerminal.start(
        Map.of(),
        "trap : INT; stty -a; %s; echo code=$?; stty -a",
        Cli.argsOn(server, "drive --yes --no-watchdog", options));
  }

  /** Returns the output of {@code stty} twice, equal before and after. */
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
    KrlPrograms.start(server.controller(), KrlPrograms.START, DriveSpace.JOINTS.program());
    return server;
  }

  @Test
  void aHeldKeyMovesTheRobotAndItStandsWhenItIsLetGo() throws Exception {
    try (MockServer server = robot();
        PseudoTerminal terminal = drive(server, "--frame=joints", "--max-delay=2s")) {
      terminal.until(READY);
      double start = server.controller().axes().a1();
      while (server.controller().axes().a1() < start + 1) {
        repeat(server, terminal, "w");
      }

      terminal.until("| standing | none |");
      while (!server.controller().standing()) {
        Thread.onSpinWait();
      }
      double stoodAt = server.controller().axes().a1();
      terminal.type("q");

      String shown = terminal.finish();
      assertThat(shown).contains("| moving | A1 +100% |", "stopped: the loop was asked to stop");
      assertThat(shown).contains("code=0");
      assertRestored(shown);
      assertThat(server.controller().axes().a1()).isEqualTo(stoodAt);
    }
  }

  @Test
  void keysThatWereTypedBeforeItStartsDoNotMoveTheRobot() throws Exception {
    CountDownLatch typed = new CountDownLatch(1);
    try (MockServer server = robot()) {
      server.fault(request -> request.name().equals("$MODE_OP"), Fault.hold(typed));
      Axis start = server.controller().axes();
      try (PseudoTerminal terminal = drive(server, "--frame=joints", "--max-delay=2s")) {
        assertThat(server.takeRequest(Duration.ofSeconds(60))).isPresent();
        terminal.type("wwwwww\rwwwwww").until("\r\nwwwwww"); // the echo
        typed.countDown();
        terminal.until(READY).until("| standing | none |").type("q");

        assertThat(terminal.finish()).contains("the robot did not move").doesNotContain("moving");
      }
      assertThat(server.controller().axes()).isEqualTo(start);
    }
  }

  /** Repeats a held key as a keyboard does: no faster than it is read, or its end comes late. */
  private static void repeat(MockServer server, PseudoTerminal terminal, String key)
      throws IOException, InterruptedException {
    terminal.type(key);
    assertThat(server.takeRequest(Duration.ofSeconds(60))).isPresent();
  }

  /** Waits for the keys to be taken, and moves the third axis, so that there is what to stop. */
  private static void move(MockServer server, PseudoTerminal terminal)
      throws IOException, InterruptedException {
    terminal.until(READY);
    double start = server.controller().axes().a3();
    while (server.controller().axes().a3() > start - 0.5) {
      repeat(server, terminal, "f");
    }
  }

  private static void assertToldToStand(MockServer server) {
    assertThat(Cli.runOn(server, "read", "MYAXIS").out()).containsPattern("A3 0(\\.0*)?,");
  }

  /** Moves the robot, and lets the command end. */
  private static void assertStopsTheRobotFirst(ThrowingConsumer<PseudoTerminal> end)
      throws Exception {
    try (MockServer server = robot();
        PseudoTerminal terminal = drive(server, "--frame=joints", "--max-delay=2s")) {
      move(server, terminal);

      end.accept(terminal);

      String shown = terminal.finish();
      assertThat(shown).contains("stopped: the loop was asked to stop", "code=0");
      assertRestored(shown);
      assertToldToStand(server);
    }
  }

  @Test
  void ctrlCStopsTheRobotFirstAndLeavesTheTerminalAsItWas() throws Exception {
    assertStopsTheRobotFirst(terminal -> terminal.type(PseudoTerminal.CTRL_C));
  }

  @Test
  void sigtermDoesTheSame() throws Exception {
    assertStopsTheRobotFirst(terminal -> terminal.command().destroy());
  }

  @Test
  void aTerminalThatIsClosedStopsTheRobot() throws Exception {
    try (MockServer server = robot();
        PseudoTerminal terminal = drive(server, "--frame=joints", "--max-delay=2s")) {
      move(server, terminal);

      ProcessHandle command = terminal.command();
      terminal.hangUp();

      command.onExit().get(60, TimeUnit.SECONDS);
      assertToldToStand(server);
    }
  }

  @Test
  void aTerminalThatGivesWholeLinesIsRefused() throws Exception {
    try (MockServer server = robot()) {
      PseudoTerminal.Shown shown =
          PseudoTerminal.run("dumb", "q ends", "", Cli.argsOn(server, "drive", "--yes"));

      assertThat(shown.code()).isEqualTo(2);
      assertThat(shown.text())
          .isEqualTo(
              "jopenshowvar: the keyboard needs a terminal that sends single keys, TERM is"
                  + " dumb\r\n");
      assertThat(server.requests()).noneMatch(RecordedRequest::isWrite);
    }
  }

  @Test
  void theTerminalIsRestoredWhenALimitEndsIt() throws Exception {
    try (MockServer server = MockServer.start(cfg -> {});
        PseudoTerminal terminal = drive(server)) {
      String shown = terminal.finish();

      assertThat(shown).contains("PROGRAM: $PRO_STATE1 must be #P_ACTIVE, is #P_FREE", "code=1");
      assertRestored(shown);
    }
  }
}
