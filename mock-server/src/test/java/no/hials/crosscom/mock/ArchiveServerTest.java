package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.ProgramCommand;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramSelectRequest;
import no.hials.crosscom.protocol.program.ProgramResponse;
import no.hials.crosscom.simulator.Archive;
import no.hials.crosscom.simulator.FileTree;
import no.hials.crosscom.simulator.LoadReport.Outcome;
import no.hials.crosscom.simulator.LoadingMode;
import no.hials.crosscom.simulator.SimulationClock;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class ArchiveServerTest {
  private static final String SOURCE =
      "DEF COUNT( )\r\n;gr\u00F6\u00DFer\r\nTOTAL=TOTAL+1\r\nEND\r\n";

  @TempDir private Path folder;

  @BeforeEach
  void write() throws IOException {
    file("R1/System/$config.dat", "DEFDAT $CONFIG\nINT TOTAL=41\nENDDAT\n");
    file("R1/Program/tools/count.src", SOURCE);
    file("R1/Program/broken.src", "DEF BROKEN( )\nTOTAL=\nEND\n");
  }

  private void file(String name, String text) throws IOException {
    Path path = folder.resolve(name);
    Files.createDirectories(path.getParent());
    Files.writeString(path, text, StandardCharsets.ISO_8859_1);
  }

  @Test
  void variablesOfTheArchiveAreThereWhenTheServerStarts() throws Exception {
    try (MockServer server = MockServer.start(cfg -> cfg.archive(folder))) {
      assertThat(server.variables().get("TOTAL")).isEqualTo("41");
      assertThat(server.archiveReport().files()).hasSize(3);
      assertThat(server.archiveReport().problems()).hasSize(1);
    }
  }

  @Test
  void aClientOfC3BridgeSelectsAndStartsAProgramOfTheArchive() throws Exception {
    try (MockServer server =
            MockServer.start(
                cfg ->
                    cfg.server(ServerType.C3_BRIDGE)
                        .clock(SimulationClock.stepped())
                        .archive(folder));
        RawClient client = new RawClient(server)) {
      ProgramSelectRequest run =
          new ProgramSelectRequest(
              1,
              Code.of(ProgramCommand.RUN),
              Code.of(Interpreter.ROBOT),
              "KRC:\\R1\\PROGRAM\\TOOLS\\COUNT.SRC",
              "",
              false);
      assertThat(((ProgramResponse) client.exchange(run)).tail().success()).isTrue();
      server
          .controller()
          .stepUntil(
              () -> server.controller().robot().state() == ProgramState.END, Duration.ofMinutes(1));

      assertThat(server.variables().get("TOTAL")).isEqualTo("42");
      assertThat(server.files().get("KRC:\\R1\\Program\\tools\\count.src"))
          .isEqualTo(SOURCE.getBytes(StandardCharsets.ISO_8859_1));
    }
  }

  @Test
  void strictlyAFileWithAnErrorIsRefused() throws Exception {
    Archive archive = Archive.open(folder);
    try (MockServer server = MockServer.start(cfg -> cfg.archive(archive, LoadingMode.STRICT))) {
      assertThat(server.archiveReport().files())
          .filteredOn(file -> file.outcome() == Outcome.REFUSED)
          .singleElement()
          .satisfies(file -> assertThat(file.path()).isEqualTo("R1/Program/broken.src"));
      assertThat(server.controller().programs()).containsExactly("COUNT");
    }
  }

  @Test
  void aMissingArchiveAndOtherFilesAreErrors() {
    assertThatThrownBy(() -> MockServer.start(cfg -> cfg.archive(folder.resolve("no.zip"))))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("there is no such file");
    assertThatThrownBy(
            () -> MockServerConfig.create(cfg -> cfg.archive(folder).files(FileTree.inMemory())))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("archive and files exclude each other");
  }
}
