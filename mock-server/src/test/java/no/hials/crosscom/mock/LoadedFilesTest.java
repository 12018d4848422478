package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.ProgramCommand;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramSelectRequest;
import no.hials.crosscom.protocol.program.ProgramResponse;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.FileTree;
import no.hials.crosscom.simulator.KrlFileException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.slf4j.LoggerFactory;

/** Tests that loaded programs are files of C3 Bridge. */
final class LoadedFilesTest {
  private static final String SOURCE = "DEF PART( )\nCOUNT=COUNT+1\nMYINT=COUNT\nEND\n";
  private static final String DATA = "DEFDAT PART\nINT COUNT=4\nENDDAT\n";

  @TempDir private Path folder;

  @KukaController(server = ServerType.C3_BRIDGE, clock = "stepped")
  private MockServer server;

  private Controller controller;

  @BeforeEach
  void start() {
    controller = server.controller();
  }

  private Path file(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text, StandardCharsets.ISO_8859_1);
  }

  private boolean select(String name) throws IOException {
    try (RawClient client = new RawClient(server)) {
      ProgramSelectRequest request =
          new ProgramSelectRequest(
              1, Code.of(ProgramCommand.SELECT), Code.of(Interpreter.SUBMIT), name, "", false);
      return ((ProgramResponse) client.exchange(request)).tail().success();
    }
  }

  private String run() {
    controller.robot().start();
    controller.stepUntil(
        () -> controller.robot().state() == ProgramState.END, java.time.Duration.ofMinutes(1));
    return server.variables().get("MYINT");
  }

  @Test
  void aLoadedModuleIsThereByteForByteWithItsDataList() throws Exception {
    file("part.dat", "\u00EF\u00BB\u00BF" + DATA);
    controller.load(file("part.src", SOURCE + "; gr\u00FC\u00DFe\r\n"));

    assertThat(server.files().list("KRC:\\R1\\Program")).containsExactly("PART.dat", "PART.src");
    assertThat(server.files().get("KRC:\\R1\\PROGRAM\\PART.SRC"))
        .isEqualTo(Files.readAllBytes(folder.resolve("part.src")));
    assertThat(server.files().get("/R1/PART.DAT"))
        .isEqualTo(Files.readAllBytes(folder.resolve("part.dat")));
  }

  @Test
  void aLoadedModuleIsNotLoadedAgainByItsSelection() throws Exception {
    controller.load("part.dat", DATA);
    controller.load("part.src", SOURCE);
    assertThat(select("/R1/PART")).isTrue();
    assertThat(run()).isEqualTo("5");

    assertThat(select("/R1/PART")).isTrue();
    assertThat(run()).as("the module keeps its variables").isEqualTo("6");
  }

  @Test
  void whatAClientPutsInItsPlaceIsLoadedByTheSelection() throws Exception {
    controller.load("part.src", SOURCE);
    server.files().put("/R1/PART.DAT", DATA.replace("4", "40"));
    assertThat(select("PART")).isTrue();
    assertThat(run()).isEqualTo("41");

    controller.load("part.src", SOURCE.replace("+1", "+2"));
    server.files().put("/R1/PART.DAT", DATA.replace("4", "50"));
    assertThat(select("PART")).isTrue();
    assertThat(run()).isEqualTo("52");
  }

  @Test
  void aLoadedModuleThatAClientDeletesCannotBeSelectedThere() throws Exception {
    controller.load("part.src", SOURCE.replace("COUNT", "MYINT"));
    assertThat(select("PART")).isTrue();
    controller.robot().cancel();

    server.files().delete("/R1/PART.SRC");

    assertThat(select("PART")).isFalse();
  }

  @Test
  void aProgramThatCannotBeSelectedIsAWarningWhateverItsErrorIs() throws Exception {
    Logger log = (Logger) LoggerFactory.getLogger("no.hials.crosscom");
    ListAppender<ILoggingEvent> events = new ListAppender<>();
    events.start();
    log.addAppender(events);
    try {
      server.files().put("/R1/BAD.SRC", "DEF BAD( )\nMYINT=\nEND\n");
      server.files().put("/R1/UNDECLARED.SRC", "DEF UNDECLARED( )\nNOSUCHVAR=1\nEND\n");

      assertThat(select("BAD")).isFalse();
      assertThat(select("UNDECLARED")).isFalse();

      assertThat(List.copyOf(events.list))
          .filteredOn(event -> event.getLevel() == Level.WARN)
          .extracting(ILoggingEvent::getFormattedMessage)
          .satisfiesExactly(
              bad -> assertThat(bad).startsWith("BAD has errors: "),
              undeclared -> assertThat(undeclared).startsWith("UNDECLARED has errors: "));
    } finally {
      log.detachAppender(events);
    }
  }

  @Test
  void aSubmitProgramHasItsEnding() throws Exception {
    controller.load("watch.sub", "DEF WATCH( )\nEND\n");

    assertThat(server.files().list("KRC:\\R1\\Program")).containsExactly("WATCH.sub");
  }

  @Test
  void whatCannotBeLoadedIsNotThere() throws Exception {
    assertThatExceptionOfType(KrlFileException.class)
        .isThrownBy(() -> controller.load("part.src", "DEF PART( )\n"));

    assertThat(server.files().list("KRC:\\R1\\Program")).isEmpty();
  }

  @Test
  void aListOfTheControllerStaysAsItIs() throws Exception {
    byte[] before = server.files().get("/R1/$config.dat");
    controller.load("$config.dat", "DEFDAT $CONFIG\nDECL INT MINE=3\nENDDAT\n");

    assertThat(server.files().get("/R1/$config.dat")).isEqualTo(before);
    assertThat(select("NONE")).isFalse();
    assertThat(server.variables().get("MINE")).isEqualTo("3");
  }

  @Test
  void aFolderOfThisMachineIsLeftToTheClients() throws Exception {
    FileTree disk = FileTree.over(folder);
    try (MockServer other = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE).files(disk))) {
      other.controller().load("part.dat", DATA);

      assertThat(other.files().list("KRC:\\R1\\Program")).isEmpty();
    }
  }
}
