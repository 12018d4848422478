package no.hials.crosscom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.bench.CheckedVariable.Kind;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Runs the soak and the mutations, shortened, and checks that they notice what is wrong. */
class TrialTest {
  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
  private final PrintStream out = new PrintStream(bytes, true, StandardCharsets.UTF_8);

  private String printed() {
    return bytes.toString(StandardCharsets.UTF_8);
  }

  @ParameterizedTest
  @EnumSource
  void aSoakFindsNothing(ServerType server) throws IOException {
    assertThat(new Soak(out, 2000, 8, 2).run(server)).as(printed()).isTrue();

    assertThat(printed()).contains("2,000 calls by 8 threads").containsPattern("faults +\\d\\d");
  }

  @ParameterizedTest
  @EnumSource
  void changedExchangesFindNothing(ServerType server) throws IOException {
    assertThat(new MutationRun(out, 500).run(server)).as(printed()).isTrue();

    for (Mutation mutation : Mutation.values()) {
      assertThat(printed()).contains("  " + mutation + " ");
    }
  }

  @Test
  void aValueThatNobodyHasWrittenIsNoticed() throws IOException {
    try (MockServer robot = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE));
        CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
      for (Kind kind : Kind.values()) {
        CheckedVariable variable = new CheckedVariable(kind, "V" + kind, robot.variables());
        client.readVariable(variable.variable());
        assertThat(variable.read()).isTrue();
        String other = robot.variables().get(variable.variable().getName()).replace('0', '7');
        robot.variables().set(variable.variable().getName(), other);

        client.readVariable(variable.variable());

        assertThat(variable.read()).as(variable.toString()).isFalse();
      }
    }
  }

  @Test
  void aWriteThatComesTwiceIsNoticedButNotOneThatComesLate() throws IOException {
    try (MockServer robot = MockServer.start()) {
      CheckedVariable variable = new CheckedVariable(Kind.AXES, "V", robot.variables());
      variable.setNext();
      assertThat(variable.received("{A1 1.0,A2 2.0}")).isTrue();
      assertThat(variable.received("{A1 1.0,A2 2.0}")).isFalse();

      variable.setNext();
      variable.unknown();
      variable.setNext();
      assertThat(variable.received("{A1 3.0,A2 4.0}")).isTrue();
      assertThat(variable.received("{A1 2.0,A2 3.0}")).isTrue();
      assertThat(variable.received("{A1 2.0,A2 3.0}")).isFalse();
    }
  }

  @Test
  void afterAWriteWithUnknownOutcomeBothValuesAreRightUntilOneIsRead() throws IOException {
    try (MockServer robot = MockServer.start();
        CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
      CheckedVariable variable = new CheckedVariable(Kind.INT, "V", robot.variables());
      variable.setNext();
      variable.received("1");
      variable.unknown();
      client.readVariable(variable.variable());
      assertThat(variable.read()).isTrue();

      robot.variables().set("V", "1");
      client.readVariable(variable.variable());

      assertThat(variable.read()).isFalse();
    }
  }
}
