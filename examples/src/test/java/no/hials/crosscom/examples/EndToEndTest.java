package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.KRL.structs.KRLE6Pos;
import no.hials.crosscom.KRL.structs.KRLPos;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.c3.Verification;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.SimulationClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** All steps of a user with a program over C3 Bridge, on a simulated controller. */
class EndToEndTest {
  private static final String SRC = "KRC:\\R1\\PROGRAM\\ACTUATOR.SRC";
  private static final String DAT = "KRC:\\R1\\PROGRAM\\ACTUATOR.DAT";
  private static final String LIST = "KRC:\\R1\\System\\$config.dat";

  private static final TransferConfig COMPARED =
      TransferConfig.create(cfg -> cfg.overwrite(true).verification(Verification.CONTENT));

  @TempDir private Path folder;
  private MockServer robot;
  private Controller controller;
  private CrossComClient client;

  @BeforeEach
  void connect() throws Exception {
    robot =
        MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE).clock(SimulationClock.stepped()));
    controller = robot.controller();
    client =
        new CrossComClient(
            ClientConfig.create(
                robot.host(),
                cfg -> cfg.port(robot.port()).requestTimeout(Duration.ofSeconds(60))));
  }

  @AfterEach
  void disconnect() throws Exception {
    client.close();
    robot.close();
  }

  private String state() throws Exception {
    return client.readText("$PRO_STATE1");
  }

  private KRLE6Pos position() throws Exception {
    KRLE6Pos position = new KRLE6Pos("$POS_ACT");
    client.readVariable(position);
    return position;
  }

  @Test
  void aProgramIsUploadedRunDrivenStoppedAndDownloaded() throws Exception {
    client.files().upload(KrlFolder.file("config.dat"), LIST, COMPARED);
    client.files().upload(KrlFolder.file("actuator.dat"), DAT);
    List<Long> progress = new ArrayList<>();
    client
        .files()
        .upload(
            KrlFolder.file("actuator.src"),
            SRC,
            TransferConfig.create(cfg -> cfg.progress((bytes, total) -> progress.add(bytes))));
    assertThat(progress).endsWith(Files.size(KrlFolder.file("actuator.src")));

    controller.setMode(OperatingMode.AUT);
    client.programs().select("/R1/ACTUATOR.SRC");
    assertThat(state()).isEqualTo("#P_RESET");
    client.programs().start(Interpreter.ROBOT);
    assertThat(state()).isEqualTo("#P_ACTIVE");
    controller.step(Duration.ofMillis(120));
    assertThat(state()).isEqualTo("#P_STOP"); // at the end of its BCO run
    client.programs().start(Interpreter.ROBOT);
    controller.step(Duration.ofMillis(120)); // until the program is in its loop

    KRLE6Pos begin = position();
    client.writeVariable(new KRLPos("MYPOS").setX(-2).setZ(1));
    controller.step(Duration.ofSeconds(1));
    client.writeVariable(new KRLPos("MYPOS"));
    assertThat(controller.stepUntil(controller::standing, Duration.ofSeconds(10))).isTrue();
    KRLE6Pos end = position();
    assertThat(end.getX()).isLessThan(begin.getX() - 20);
    assertThat(end.getZ()).isGreaterThan(begin.getZ() + 10);

    client.programs().stop(Interpreter.ROBOT);
    assertThat(state()).isEqualTo("#P_STOP");
    client.writeVariable(new KRLPos("MYPOS").setX(5));
    controller.step(Duration.ofSeconds(1));
    assertThat(position().getX()).as("a stopped program moves nothing").isEqualTo(end.getX());

    Path back = folder.resolve("actuator.src");
    client.files().download(SRC, back);
    assertThat(back).hasSameBinaryContentAs(KrlFolder.file("actuator.src"));
    assertThat(client.files().download(DAT))
        .isEqualTo(Files.readAllBytes(KrlFolder.file("actuator.dat")));
  }

  @Test
  void aProgramWithErrorsIsRefusedByItsSelectionAndCanBeMended() throws Exception {
    String good = Files.readString(KrlFolder.file("actuator.src"));
    client.files().upload(KrlFolder.file("config.dat"), LIST, COMPARED);
    client.files().upload(KrlFolder.file("actuator.dat"), DAT);
    client.files().uploadText(good.replace("ENDLOOP", "END LOOP"), SRC, COMPARED);

    assertThatExceptionOfType(CrossComRefusedException.class)
        .isThrownBy(() -> client.programs().select("/R1/ACTUATOR"))
        .withMessageContaining("selection of program /R1/ACTUATOR")
        .satisfies(e -> assertThat(e.getErrorCode()).contains(ErrorCode.GENERAL));
    assertThat(state()).isEqualTo("#P_FREE");

    client.files().uploadText(good, SRC, COMPARED);
    client.programs().select("/R1/ACTUATOR");
    assertThat(state()).isEqualTo("#P_RESET");
  }
}
