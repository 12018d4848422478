package no.hials.crosscom.compat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Runs programs written for JOpenShowVar 0.2.2, which know nothing of this implementation. */
class OriginalProgramsTest {
  private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
  private final PrintStream original = System.out;
  @KukaController private MockServer robot;

  @BeforeEach
  void start() throws Exception {
    System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
  }

  @AfterEach
  void stop() {
    System.setOut(original);
  }

  private String output() {
    return printed.toString(StandardCharsets.UTF_8);
  }

  @Test
  void theProgramOfTheReadmeRunsAndPrintsWhatTheControllerHolds() throws Exception {
    OriginalReadme.main(new String[] {robot.host(), String.valueOf(robot.port())});

    assertThat(output().lines())
        .satisfiesExactly(
            line ->
                assertThat(line)
                    .matches(
                        "KRLVariable\\{id=\\d+, name=MYPOS, value=\\{X=2.0, Y=1.0, Z=0.0, A=0.0,"
                            + " B=0.0, C=0.0, S=0.0, T=0.0\\}, readTime=\\d+ms\\}"),
            line -> assertThat(line).contains("{X=2.0, Y=1.0, Z=0.0,"),
            line -> assertThat(line).contains("{A1=0.0, A2=-90.0, A3=90.0, A4=0.0,"),
            line -> assertThat(line).contains("name=$OV_JOG, value=10.0,"),
            line -> assertThat(line).contains("name=$OV_PRO, value=99.0,"),
            line -> assertThat(line).contains("name=$OUT[1], value=false,"),
            line -> assertThat(line).contains("name=$MODE_OP, value=#T1,"),
            line -> assertThat(line).isEqualTo("[0.0, -90.0, 90.0, 0.0, 0.0, 0.0]"),
            line -> assertThat(line).isEqualTo("[0.0, 0.0, 0.0, 0.0, 0.0, 0.0]"),
            line -> assertThat(line).matches("\\$OV_JOG #read time=\\d+ms  #value=10"),
            line -> assertThat(line).matches("\\$OV_JOG #read time=\\d+ms  #value=90"));
    assertThat(robot.variables().get("$OV_PRO")).isEqualTo("99");
    assertThat(robot.variables().get("$OV_JOG")).isEqualTo("90");
    assertThat(robot.requests().get(0).value())
        .isEqualTo("{X 2.0,Y 1.0,Z 0.0,A 0.0,B 0.0,C 0.0,S 0,T 0}");
  }

  @Test
  void programsOfVersion01AndTheSamplesRun() throws Exception {
    OriginalVersion01 program = new OriginalVersion01();
    program.connect(robot.host(), robot.port());
    program.sendRequests();
    program.structures();
    program.close();

    assertThat(output().lines())
        .satisfiesExactly(
            line -> assertThat(line).isEqualTo("time-out 2000"),
            line ->
                assertThat(line)
                    .matches(
                        "Callback\\{variable=\\$OV_JOG, id=0, option=0, readTime=\\d+ms,"
                            + " value=10\\}"),
            line -> assertThat(line).contains("option=1").endsWith("value=100}"),
            line -> assertThat(line).isEqualTo("$OV_JOG 100 7"),
            line -> assertThat(line).isEqualTo("jog 100"),
            line -> assertThat(line).isEqualTo("X is 0.0"),
            line -> assertThat(line).isEqualTo("frame 10.0 3.0"),
            line ->
                assertThat(line)
                    .isEqualTo(
                        "axes {A1 0.0,A2 -90.0,A3 90.0,A4 0.0,A5 45.0,A6 0.0,E1 5.0,E2 0.0,E3 0.0,"
                            + "E4 0.0,E5 0.0,E6 0.0}"),
            line -> assertThat(line).isEqualTo("x of an axis variable 525.0"),
            line -> assertThat(line).isEqualTo("z 890.0 nodes 14"),
            line -> assertThat(line).isEqualTo("state 3 of type KRLInt"),
            line -> assertThat(line).isEqualTo("closed true connected true"));
    assertThat(robot.requests())
        .filteredOn(r -> r.name().equals("MYFRAME"))
        .extracting(RecordedRequest::value)
        .as("the second write of a structure sends the same as the first")
        .hasSize(2)
        .containsOnly("{X 10.0,Y 20.0,Z 30.0,A 1.0,B 2.0,C 3.0}");
  }

  @Test
  void aFailedConnectionIsCaughtAsTheIoExceptionThatProgramsExpect() throws Exception {
    int port = robot.port();
    robot.close();

    new OriginalVersion01().connect("127.0.0.1", port);

    assertThat(output()).startsWith("no connection could not connect to 127.0.0.1:" + port);
  }
}
