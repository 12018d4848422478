package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.lang.reflect.Method;
import java.time.Duration;
import java.util.function.BooleanSupplier;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.SimulationClock;
import no.hials.crosscom.simulator.VariableTable;
import no.hials.crosscom.simulator.internal.data.Scope;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests all clocks, the threads of the simulation, its end and its errors. */
class ControllerClockTest {
  private static final String RUNAWAY =
      "LOOP\nMYINT=MYINT+1\nIF MYINT>1000000 THEN\nMYINT=0\nENDIF\nENDLOOP";

  private static MockServer start(SimulationClock clock) throws IOException {
    return MockServer.start(cfg -> cfg.clock(clock));
  }

  private static void run(Controller controller, String body) throws KrlFileException {
    controller.setMode(OperatingMode.AUT);
    controller.load("test.src", "DEF TEST()\n" + body + "\nEND\n");
    controller.robot().select("TEST");
    controller.runProgram();
  }

  private static boolean hasClockThread(int port) {
    String name = "mock-server-" + port + "-clock";
    return Thread.getAllStackTraces().keySet().stream()
        .anyMatch(thread -> thread.getName().equals(name));
  }

  /** Waits for a condition that must become true, at most until the time limit of the build. */
  private static void await(BooleanSupplier condition) {
    while (!condition.getAsBoolean()) {
      Thread.onSpinWait();
    }
  }

  // clocks

  @ParameterizedTest
  @ValueSource(strings = {"real", "50", "max"})
  void runsAProgramByItself(String clock) throws Exception {
    try (MockServer server = start(SimulationClock.parse(clock))) {
      Controller controller = server.controller();
      run(controller, "PTP {A1 1}\nMYINT=5");
      await(() -> controller.robot().state() == ProgramState.END);
      assertThat(controller.axes().get(0)).isEqualTo(1);
      assertThat(server.variables().get("MYINT")).isEqualTo("5");
      assertThat(hasClockThread(server.port())).isTrue();
      assertThatThrownBy(() -> controller.step(Duration.ofMillis(12)))
          .isInstanceOf(IllegalStateException.class)
          .hasMessageStartingWith("stepping needs SimulationClock.stepped()");
    }
  }

  @Test
  void needsNoThreadBeforeItIsAskedForAndNoneToBeStepped() throws IOException {
    try (MockServer server = start(SimulationClock.real())) {
      assertThat(hasClockThread(server.port())).isFalse();
    }
    try (MockServer server = start(SimulationClock.stepped())) {
      server.controller().step(Duration.ofMillis(12));
      assertThat(hasClockThread(server.port())).isFalse();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"real", "10000", "max", "0.001"})
  void leavesNoThreadBehind(String clock) throws Exception {
    MockServer server = start(SimulationClock.parse(clock));
    run(server.controller(), RUNAWAY);
    int port = server.port();
    assertThat(hasClockThread(port)).isTrue();
    server.close();
    assertThat(hasClockThread(port)).isFalse();
    assertThatThrownBy(server::controller).hasMessage("the server is closed");
  }

  @Test
  void givesTheSameController() throws IOException {
    try (MockServer server = start(SimulationClock.stepped())) {
      assertThat(server.controller()).isSameAs(server.controller());
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"0", "-1", "10001", "NaN", "fast"})
  void refusesAnImpossibleClock(String text) {
    assertThatThrownBy(() -> SimulationClock.parse(text))
        .isInstanceOf(IllegalArgumentException.class);
  }

  // steps

  @Test
  void roundsAStepUpToWholeCycles() throws IOException {
    try (MockServer server = start(SimulationClock.stepped())) {
      Controller controller = server.controller();
      controller.step(Duration.ZERO);
      assertThat(controller.time()).isZero();
      controller.step(Duration.ofNanos(1));
      assertThat(controller.time()).hasMillis(12);
      controller.step(Duration.ofMillis(24));
      assertThat(controller.time()).hasMillis(36);
      controller.step(Duration.ofMillis(25));
      assertThat(controller.time()).hasMillis(72);
    }
  }

  // several controllers

  @ParameterizedTest
  @ValueSource(strings = {"real", "max"})
  void servesClientsAndPendantWhileProgramsNeverWait(String clock) throws Exception {
    try (MockServer server = start(SimulationClock.parse(clock));
        RawClient client = new RawClient(server)) {
      Controller controller = server.controller();
      controller.load("sps.sub", "DEF SPS()\nLOOP\nMYINTS[1]=1\nENDLOOP\nEND\n");
      controller.submit().select("SPS");
      controller.submit().start();
      run(controller, RUNAWAY);
      long before = controller.time().toMillis();
      for (int i = 0; i < 200; i++) {
        assertThat(client.read("$PRO_STATE1").value()).isEqualTo("#P_ACTIVE");
        assertThat(client.write("MYREAL", String.valueOf(i)).tail().success()).isTrue();
        assertThat(controller.mode()).isEqualTo(OperatingMode.AUT);
      }
      await(() -> controller.time().toMillis() > before);
      controller.robot().stop();
      assertThat(client.read("$PRO_STATE1").value()).isEqualTo("#P_STOP");
    }
  }

  /** Makes each write to MYINT fail with an error that is not the controller's. */
  private static void breakMyInt(VariableTable variables) throws ReflectiveOperationException {
    Method scope = VariableTable.class.getDeclaredMethod("scope");
    scope.setAccessible(true);
    ((Scope) scope.invoke(variables))
        .guard(
            "MYINT",
            (path, value) -> {
              throw new UnsupportedOperationException("broken on purpose");
            });
  }

  @Test
  void anErrorOfTheSimulationStopsTheProgramsAndLeavesTheServer() throws Exception {
    try (MockServer server = start(SimulationClock.unlimited());
        RawClient client = new RawClient(server)) {
      Controller controller = server.controller();
      breakMyInt(server.variables());
      run(controller, "MYINT=1");
      await(() -> !controller.messages().isEmpty());

      assertThat(controller.messages().get(0))
          .hasToString(
              "9107 the simulation has failed:"
                  + " java.lang.UnsupportedOperationException: broken on purpose");
      assertThat(client.read("$PRO_STATE1").value()).isEqualTo("#P_STOP");
      assertThat(client.read("$STOPMESS").value()).isEqualTo("TRUE");
      controller.confirmAll();
      assertThatThrownBy(() -> controller.robot().start())
          .isInstanceOf(IllegalStateException.class)
          .hasMessageStartingWith("start: the simulation has failed:")
          .hasCauseInstanceOf(UnsupportedOperationException.class);
      assertThatThrownBy(() -> controller.submit().start())
          .hasMessageStartingWith("start: the simulation has failed:");
    }
  }
}
