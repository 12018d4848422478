package no.hials.crosscom.mock.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;
import static org.junit.platform.testkit.engine.EventConditions.finishedWithFailure;
import static org.junit.platform.testkit.engine.TestExecutionResultConditions.message;

import java.io.IOException;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.time.Duration;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RawClient;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.simulator.Controller;
import org.junit.jupiter.api.Disabled;
import org.junit.jupiter.api.Test;
import org.junit.platform.testkit.engine.EngineTestKit;

/** Tests servers that run the programs of their annotation. */
class KukaControllerProgramsTest {
  private static final Duration SECOND = Duration.ofSeconds(1);

  private static boolean hasClockThread(MockServer server) {
    String name = "mock-server-" + server.port() + "-clock";
    return Thread.getAllStackTraces().keySet().stream()
        .anyMatch(thread -> thread.getName().equals(name));
  }

  @Test
  void runsAProgramOfTheClasspathWithItsDataList(
      @KukaController(
              dataLists = {"classpath:cell.dat", "classpath:count.dat"},
              programs = {"classpath:/no/hials/crosscom/mock/junit/count.src"},
              start = "COUNT",
              mode = OperatingMode.AUT,
              clock = "stepped")
          MockServer server) {
    Controller controller = server.controller();
    assertThat(controller.robot().state()).isEqualTo(ProgramState.ACTIVE);
    assertThat(controller.mode()).isEqualTo(OperatingMode.AUT);
    controller.step(SECOND);
    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
    assertThat(server.variables().get("CELL_COUNT")).isEqualTo("42");
  }

  @Test
  void runsAProgramOfAFileWithTheDataListBesideIt(
      @KukaController(
              dataLists = "src/test/resources/no/hials/crosscom/mock/junit/cell.dat",
              programs = "src/test/resources/no/hials/crosscom/mock/junit/count.src",
              start = "COUNT",
              mode = OperatingMode.EXT,
              clock = "stepped")
          MockServer server) {
    server.controller().step(SECOND);
    assertThat(server.controller().robot().state()).isEqualTo(ProgramState.END);
    assertThat(server.variables().get("CELL_COUNT")).isEqualTo("42");
  }

  @Test
  void runsASubmitProgram(
      @KukaController(
              dataLists = {"classpath:cell.dat", "classpath:count.dat"},
              programs = "classpath:count.src",
              submit = "COUNT",
              clock = "max")
          MockServer server) {
    while (server.controller().submit().state() == ProgramState.ACTIVE) {
      Thread.onSpinWait();
    }
    assertThat(server.variables().get("CELL_COUNT")).isEqualTo("42");
    assertThat(server.controller().robot().state()).isEqualTo(ProgramState.FREE);
  }

  @Test
  void runsAProgramOfAnArchive(
      @KukaController(
              archive = "src/test/resources/no/hials/crosscom/mock/junit/archive",
              start = "PICK",
              mode = OperatingMode.AUT,
              clock = "stepped")
          MockServer server)
      throws IOException {
    Controller controller = server.controller();
    assertThat(controller.axes().a1()).as("XHOME of the archive").isEqualTo(30);
    assertThat(controller.submit().state()).isEqualTo(ProgramState.ACTIVE);

    controller.step(SECOND.multipliedBy(2));

    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
    try (RawClient client = new RawClient(server)) {
      assertThat(client.read("PARTS").value()).isEqualTo("42");
      assertThat(Integer.parseInt(client.read("CYCLES").value())).isPositive();
      assertThat(client.read("$AXIS_ACT.A1").value()).isEqualTo("20.0000");
    }
  }

  @Test
  void letsTheVariablesStandStillIfNoControllerIsAskedFor(
      @KukaController(dataLists = "classpath:cell.dat") MockServer server) {
    assertThat(hasClockThread(server)).isFalse();
    assertThat(server.variables().get("CELL_COUNT")).isEqualTo("1");
    server.variables().set("$POS_ACT.X", "7");
    assertThat(server.variables().get("$POS_ACT.X")).isEqualTo("7.00000");
  }

  // errors

  /** Keeps an IDE from running a class that fails on purpose. */
  @Disabled("run by a test of the class around it")
  @Retention(RetentionPolicy.RUNTIME)
  private @interface RunByATest {}

  @RunByATest
  static class WrongProgram {
    @KukaController(programs = "classpath:wrong.src")
    static MockServer server;

    @Test
    void test() {}
  }

  @RunByATest
  static class UnknownNameInTheProgram {
    @KukaController(programs = "classpath:count.src", start = "COUNT")
    static MockServer server;

    @Test
    void test() {}
  }

  @RunByATest
  static class UnknownModule {
    @KukaController(submit = "GHOST")
    static MockServer server;

    @Test
    void test() {}
  }

  @RunByATest
  static class MissingResource {
    @KukaController(dataLists = "classpath:ghost.dat")
    static MockServer server;

    @Test
    void test() {}
  }

  @RunByATest
  static class MissingFile {
    @KukaController(programs = "ghost.src")
    static MockServer server;

    @Test
    void test() {}
  }

  @RunByATest
  static class MissingArchive {
    @KukaController(archive = "ghost.zip")
    static MockServer server;

    @Test
    void test() {}
  }

  @RunByATest
  static class WrongClock {
    @KukaController(clock = "soon")
    static MockServer server;

    @Test
    void test() {}
  }

  private static void assertFailsToStart(Class<?> tests, String reason) {
    EngineTestKit.engine("junit-jupiter")
        .configurationParameter("junit.jupiter.conditions.deactivate", "*DisabledCondition")
        .selectors(selectClass(tests))
        .execute()
        .allEvents()
        .assertThatEvents()
        .haveExactly(1, finishedWithFailure(message(text -> text.contains(reason))));
  }

  @Test
  void saysWhatIsWrongInAProgram() {
    assertFailsToStart(WrongProgram.class, "WrongProgram.server: wrong.src:2:");
    assertFailsToStart(
        UnknownNameInTheProgram.class, "UnknownNameInTheProgram.server: count.src:3:");
  }

  @Test
  void saysWhatIsNotThere() {
    assertFailsToStart(UnknownModule.class, "no module GHOST is loaded");
    assertFailsToStart(MissingResource.class, "resource not found: ghost.dat");
    assertFailsToStart(MissingFile.class, "ghost.src: there is no such file");
    assertFailsToStart(MissingArchive.class, "ghost.zip");
  }

  @Test
  void saysWhatIsNoClock() {
    assertFailsToStart(WrongClock.class, "a clock is real, max, stepped or a factor");
  }
}
