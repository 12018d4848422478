package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Axis;
import org.junit.jupiter.api.Test;

/** Lets time pass in steps, and breaks the simulation. */
class SimulatedTimeTest {
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
        .hasMessageContaining("step: the controller is closed");
    assertThatThrownBy(() -> cell.controller.step(Duration.ofMillis(12)))
        .hasMessage("step: the controller is closed");
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

  private static List<Axis> trajectory() throws Exception {
    try (Cell cell = new Cell()) {
      cell.start(MIXED);
      List<Axis> axes = new ArrayList<>();
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
    List<Axis> first = trajectory();
    assertThat(first).hasSizeGreaterThan(100).isEqualTo(trajectory());
  }

  @Test
  void everyClockGivesTheSameTrajectory() throws Exception {
    List<Axis> stepped = trajectory();
    try (Controller controller = Cell.with(VariableTable.krc4(), SimulationClock.unlimited())) {
      controller.place(Cell.START);
      controller.setMode(OperatingMode.AUT);
      controller.load("test.src", Cell.module("TEST", MIXED.replace("$DATE.SEC<31", "TRUE")));
      controller.robot().select("TEST");
      controller.robot().start();
      Cell.await(() -> controller.robot().state() != ProgramState.ACTIVE);
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

  @Test
  void anErrorOfTheSimulationComesOutOfAStep() throws Exception {
    try (Cell cell = new Cell()) {
      BrokenVariable.breakMyInt(cell.controller.variables());
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

  @Test
  void timeGoesOnAfterACycleWithoutMemory() throws Exception {
    VariableTable variables = VariableTable.krc4();
    BrokenVariable.exhaustMemory(variables);
    try (Controller controller = Cell.with(variables, SimulationClock.times(100))) {
      controller.load("job.src", Cell.module("JOB", "MYINT=1"));
      controller.submit().select("JOB");
      controller.submit().start();

      Cell.await(() -> !controller.messages().isEmpty());

      assertThat(controller.messages().get(0).toString())
          .contains("the simulation has failed", "no memory");
      Duration before = controller.time();
      Cell.await(() -> controller.time().compareTo(before) > 0);
    }
  }
}
