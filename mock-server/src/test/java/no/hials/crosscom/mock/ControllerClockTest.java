package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import no.hials.crosscom.kinematics.Axes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Lets time pass in all ways, and looks at threads, the end, and errors of the simulation. */
class ControllerClockTest {
  private static final String RUNAWAY =
      "LOOP\nMYINT=MYINT+1\nIF MYINT>1000000 THEN\nMYINT=0\nENDIF\nENDLOOP";

  private static MockServer start(Clock clock) throws IOException {
    return MockServer.start(cfg -> cfg.clock(clock));
  }

  private static void run(Controller controller, String body) throws KrlFileException {
    controller.setMode(OperatingMode.AUT);
    controller.load("test.src", Cell.module("TEST", body));
    controller.robot().select("TEST");
    controller.robot().start();
  }

  private static boolean hasClockThread(int port) {
    String name = "mock-server-" + port + "-clock";
    return Thread.getAllStackTraces().keySet().stream()
        .anyMatch(thread -> thread.getName().equals(name));
  }

  /** Waits for something that must come; the build's time limit ends it otherwise. */
  private static void await(BooleanSupplier condition) {
    while (!condition.getAsBoolean()) {
      Thread.onSpinWait();
    }
  }

  // clocks

  @ParameterizedTest
  @ValueSource(strings = {"real", "50", "max"})
  void runsAProgramByItself(String clock) throws Exception {
    try (MockServer server = start(Clock.parse(clock))) {
      Controller controller = server.controller();
      run(controller, "PTP {A1 1}\nMYINT=5");
      await(() -> controller.robot().state() == ProgramState.END);
      assertThat(controller.axes().get(0)).isEqualTo(1);
      assertThat(server.variables().get("MYINT")).isEqualTo("5");
      assertThat(hasClockThread(server.port())).isTrue();
      assertThatThrownBy(() -> controller.step(Duration.ofMillis(12)))
          .isInstanceOf(IllegalStateException.class)
          .hasMessageStartingWith("stepping needs Clock.stepped()");
    }
  }

  @Test
  void needsNoThreadBeforeItIsAskedForAndNoneToBeStepped() throws IOException {
    try (MockServer server = start(Clock.real())) {
      assertThat(hasClockThread(server.port())).isFalse();
    }
    try (MockServer server = start(Clock.stepped())) {
      server.controller().step(Duration.ofMillis(12));
      assertThat(hasClockThread(server.port())).isFalse();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"real", "10000", "max", "0.001"})
  void leavesNoThreadBehind(String clock) throws Exception {
    MockServer server = start(Clock.parse(clock));
    run(server.controller(), RUNAWAY);
    int port = server.port();
    assertThat(hasClockThread(port)).isTrue();
    server.close();
    assertThat(hasClockThread(port)).isFalse();
    assertThatThrownBy(server::controller).hasMessage("the server is closed");
  }

  @Test
  void givesTheSameController() throws IOException {
    try (MockServer server = start(Clock.stepped())) {
      assertThat(server.controller()).isSameAs(server.controller());
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"0", "-1", "10001", "NaN", "fast"})
  void refusesAnImpossibleClock(String text) {
    assertThatThrownBy(() -> Clock.parse(text)).isInstanceOf(IllegalArgumentException.class);
  }

  // steps

  @Test
  void roundsAStepUpToWholeCycles() throws IOException {
    try (MockServer server = start(Clock.stepped())) {
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

  @Test
  void stepsUntilSomethingIsTrueOrTheTimeIsOver() throws Exception {
    try (Cell cell = new Cell()) {
      assertThat(cell.controller.stepUntil(() -> true, Duration.ZERO)).isTrue();
      assertThat(cell.controller.time()).isZero();
      assertThat(cell.controller.stepUntil(() -> false, Duration.ofMillis(30))).isFalse();
      assertThat(cell.controller.time()).hasMillis(36);
      Controller controller = cell.controller;
      assertThat(
              controller.stepUntil(() -> controller.time().toMillis() >= 60, Duration.ofDays(9999)))
          .isTrue();
      assertThat(cell.controller.time()).hasMillis(60);
    }
  }

  @Test
  void twoThreadsThatStepLetTheirTimesPassBoth() throws Exception {
    try (Cell cell = new Cell()) {
      CompletableFuture<Void> other =
          CompletableFuture.runAsync(() -> cell.controller.step(Duration.ofMillis(1200)));
      cell.controller.step(Duration.ofMillis(1200));
      other.get();
      assertThat(cell.controller.time()).hasMillis(2400);
    }
  }

  @Test
  void closingEndsAStepUnderWay() throws Exception {
    Cell cell = new Cell();
    CountDownLatch under = new CountDownLatch(1);
    CompletableFuture<Boolean> step =
        CompletableFuture.supplyAsync(
            () ->
                cell.controller.stepUntil(
                    () -> {
                      under.countDown();
                      return false;
                    },
                    Duration.ofDays(365_000)));
    under.await();
    cell.close();
    assertThatThrownBy(step::get)
        .isInstanceOf(ExecutionException.class)
        .hasCauseInstanceOf(IllegalStateException.class)
        .hasMessageContaining("step: the server is closed");
    assertThatThrownBy(() -> cell.controller.step(Duration.ofMillis(12)))
        .hasMessage("step: the server is closed");
  }

  // others besides

  @ParameterizedTest
  @ValueSource(strings = {"real", "max"})
  void servesClientsAndPendantWhileProgramsNeverWait(String clock) throws Exception {
    try (MockServer server = start(Clock.parse(clock));
        RawClient client = new RawClient(server)) {
      Controller controller = server.controller();
      controller.load("sps.sub", Cell.module("SPS", "LOOP\nMYINTS[1]=1\nENDLOOP"));
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

  // determinism

  private static final String MIXED =
      """
      BAS(#INITMOV,0)
      TRIGGER WHEN DISTANCE=1 DELAY=-50 DO $OUT[1]=TRUE
      PTP {A1 20,A5 30} C_PTP
      LIN_REL {X -40,Z 20} C_DIS
      LIN_REL {Y 30,A 10} C_DIS
      CIRC_REL {X 20,Y 20},{X 40,Y 0}
      WAIT SEC 0.1
      $OV_PRO=40
      PTP_REL {A6 -50}
      IF $DATE.SEC<31 THEN
        PTP_REL {A1 1}
      ENDIF
      PTP {A1 0,A2 -90,A3 90,A4 0,A5 45,A6 0}\
      """;

  private static List<Axes> trajectory() throws Exception {
    try (Cell cell = new Cell()) {
      cell.start(MIXED);
      List<Axes> axes = new ArrayList<>();
      cell.until(
          () -> {
            axes.add(cell.controller.axes());
            return cell.controller.robot().state() != ProgramState.ACTIVE;
          });
      assertThat(cell.controller.messages()).isEmpty();
      return axes;
    }
  }

  @Test
  void theSameProgramGivesTheSameTrajectoryBitByBit() throws Exception {
    List<Axes> first = trajectory();
    assertThat(first).hasSizeGreaterThan(100).isEqualTo(trajectory());
  }

  @Test
  void everyClockGivesTheSameTrajectory() throws Exception {
    List<Axes> stepped = trajectory();
    try (MockServer server = start(Clock.unlimited())) {
      Controller controller = server.controller();
      controller.place(Cell.START);
      run(controller, MIXED.replace("$DATE.SEC<31", "TRUE"));
      await(() -> controller.robot().state() != ProgramState.ACTIVE);
      assertThat(controller.messages()).isEmpty();
      assertThat(controller.axes()).isEqualTo(stepped.get(stepped.size() - 1));
    }
  }

  // full speed

  @Test
  void runsAProgramOfTenMinutes() throws Exception {
    try (Cell cell = new Cell()) {
      cell.submit("LOOP\nMYBOOL=$IN[1]\nENDLOOP");
      cell.start(
          """
          BAS(#INITMOV,0)
          LOOP
            PTP {A1 30,A2 -80} C_PTP
            PTP {A1 -30,A2 -90,A5 60} C_PTP
            PTP {A1 0,A2 -90,A3 90,A4 0,A5 45,A6 0}
            LIN_REL {X -50} C_DIS
            LIN_REL {Z 50} C_DIS
            LIN_REL {X 50} C_DIS
            LIN_REL {Z -50} C_DIS
            MYINT=MYINT+1
          ENDLOOP\
          """);
      cell.controller.step(Duration.ofMinutes(10));
      assertThat(cell.controller.time()).hasMinutes(10);
      assertThat(cell.controller.messages()).isEmpty();
      assertThat(Integer.parseInt(cell.get("MYINT"))).isGreaterThan(100);
    }
  }

  // errors of the simulation itself

  private static void breakMyInt(MockServer server) {
    server
        .variables()
        .scope()
        .guard(
            "MYINT",
            (path, value) -> {
              throw new UnsupportedOperationException("broken on purpose");
            });
  }

  @Test
  void anErrorOfTheSimulationStopsTheProgramsAndLeavesTheServer() throws Exception {
    try (MockServer server = start(Clock.unlimited());
        RawClient client = new RawClient(server)) {
      Controller controller = server.controller();
      breakMyInt(server);
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

  @Test
  void anErrorOfTheSimulationComesOutOfAStep() throws Exception {
    try (Cell cell = new Cell()) {
      breakMyInt(cell.server);
      cell.start("MYINT=1");
      assertThatThrownBy(() -> cell.cycles(1)).isInstanceOf(UnsupportedOperationException.class);
      assertThat(cell.message()).startsWith("9107");
      cell.cycles(1);
      assertThat(cell.controller.robot().state()).isEqualTo(ProgramState.STOP);
      CompletableFuture<OperatingMode> other =
          CompletableFuture.supplyAsync(() -> cell.controller.mode());
      assertThat(other.get(20, TimeUnit.SECONDS)).isEqualTo(OperatingMode.AUT);
    }
  }
}
