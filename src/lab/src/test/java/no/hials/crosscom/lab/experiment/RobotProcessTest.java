package no.hials.crosscom.lab.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.simulator.KrlPrograms;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class RobotProcessTest {
  @Test
  @Timeout(60)
  void runsTheProgramUntilNobodyIsThereToTellItAnything() throws Exception {
    Process process = RobotProcess.start("none", KrlPrograms.START, RobotProgram.EXT_MOVE_AXIS);
    try (BufferedReader said = process.inputReader(StandardCharsets.US_ASCII)) {
      String host = said.readLine();
      assertThat(host).isEqualTo("127.0.0.1");
      try (CrossComClient client = new CrossComClient(host, Integer.parseInt(said.readLine()))) {
        assertThat(client.readText("$PRO_STATE1")).isEqualTo("#P_ACTIVE");
        assertThat(client.readText("$AXIS_ACT.A5")).isEqualTo("45.0000");
      }
      assertThat(process.isAlive()).isTrue();

      process.outputWriter().close();

      assertThat(process.waitFor(30, TimeUnit.SECONDS)).isTrue();
      assertThat(process.exitValue()).isZero();
    } finally {
      process.destroyForcibly();
    }
  }
}
