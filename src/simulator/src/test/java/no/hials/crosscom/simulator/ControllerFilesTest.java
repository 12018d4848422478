package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Loads programs and data lists, in any order, and some that are wrong. */
class ControllerFilesTest {
  private static final String SOURCE = Cell.module("PART", "COUNT=COUNT+1\nMYINT=COUNT");
  private static final String DATA = "DEFDAT PART\nINT COUNT=4\nENDDAT\n";

  @TempDir private Path folder;
  private Cell cell;
  private Controller controller;

  @BeforeEach
  void open() throws IOException {
    cell = new Cell();
    controller = cell.controller;
  }

  @AfterEach
  void close() {
    cell.close();
  }

  private Path file(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text, StandardCharsets.ISO_8859_1);
  }

  private String runPart() throws KrlFileException {
    controller.robot().select("PART");
    controller.robot().start();
    cell.runToTheEnd();
    return cell.get("MYINT");
  }

  @Test
  void takesFilesThatAnEditorHasMarkedAsUtf8() throws Exception {
    file("part.dat", "\u00EF\u00BB\u00BF" + DATA);

    controller.load(file("part.src", "\u00EF\u00BB\u00BF" + SOURCE));

    assertThat(runPart()).isEqualTo("5");
  }

  // order

  @Test
  void takesADataListBeforeItsSource() throws Exception {
    assertThat(controller.load("part.dat", DATA)).isEqualTo("PART");
    assertThat(controller.programs()).isEmpty();
    assertThat(controller.load("part.src", SOURCE)).isEqualTo("PART");
    assertThat(controller.programs()).containsExactly("PART");
    assertThat(runPart()).isEqualTo("5");
  }

  @Test
  void takesADataListBehindItsSource() throws Exception {
    controller.load("part.src", SOURCE);
    assertThat(controller.check("PART")).isNotEmpty();
    controller.load("part.dat", DATA);
    assertThat(controller.check("PART")).isEmpty();
    assertThat(runPart()).isEqualTo("5");
  }

  @Test
  void keepsTheDataListOfAModuleWhoseSourceIsReplaced() throws Exception {
    controller.load("part.dat", DATA);
    controller.load("part.src", SOURCE);
    controller.load("part.src", Cell.module("part", "MYINT=10*COUNT"));
    assertThat(runPart()).isEqualTo("40");
  }

  @Test
  void aModuleKeepsItsVariablesBetweenItsRuns() throws Exception {
    controller.load("part.dat", DATA);
    controller.load("part.src", SOURCE);
    assertThat(runPart()).isEqualTo("5");
    assertThat(runPart()).isEqualTo("6");
    controller.load("part.dat", DATA);
    assertThat(runPart()).isEqualTo("5");
  }

  @Test
  void clientsSeeWhatAPublicDataListDeclaresGlobal() throws Exception {
    controller.load(
        "part.dat", "DEFDAT PART PUBLIC\nDECL GLOBAL INT SEEN=3\nINT HIDDEN=1\nENDDAT\n");
    controller.load("part.src", Cell.module("PART", "SEEN=SEEN+HIDDEN"));
    assertThat(cell.get("SEEN")).isEqualTo("3");
    controller.robot().select("PART");
    controller.robot().start();
    cell.runToTheEnd();
    assertThat(cell.get("SEEN")).isEqualTo("4");
    assertThat(controller.variables().contains("HIDDEN")).isFalse();
  }

  // errors

  @Test
  void saysWhatIsWrongInADataListAtOnceAndChangesNothing() throws Exception {
    controller.load("part.dat", DATA);
    controller.load("part.src", SOURCE);
    assertThatThrownBy(
            () -> controller.load("part.dat", "DEFDAT PART\nINT COUNT=TRUE\nGHOST G\nENDDAT\n"))
        .isInstanceOfSatisfying(KrlFileException.class, e -> assertThat(e.errors()).hasSize(2));
    assertThat(runPart()).isEqualTo("5");
  }

  @Test
  void refusesADataListThatIsWrongBeforeItsSourceComes() {
    assertThatThrownBy(() -> controller.load("part.dat", "DEFDAT PART\nINT N=TRUE\nENDDAT\n"))
        .isInstanceOf(KrlFileException.class)
        .hasMessageStartingWith("part.dat:2:");
  }

  @Test
  void refusesASourceThatIsWrongAndKeepsTheOldOne() throws Exception {
    controller.load("part.src", Cell.module("PART", "MYINT=1"));
    assertThatThrownBy(() -> controller.load("part.src", "DEF PART()\nMYINT=\nIF\nEND\n"))
        .isInstanceOf(KrlFileException.class)
        .hasMessageStartingWith("part.src:2:");
    assertThat(runPart()).isEqualTo("1");
  }

  @Test
  void refusesAnEmptyFile() {
    assertThatThrownBy(() -> controller.load("part.src", "")).isInstanceOf(KrlFileException.class);
  }

  // files

  @Test
  void loadsTheDataListBesideAProgram() throws Exception {
    file("PART.DAT", DATA);
    assertThat(controller.load(file("part.src", SOURCE))).isEqualTo("PART");
    assertThat(runPart()).isEqualTo("5");
  }

  @Test
  void loadsTheDataListInTheCaseOfItsProgram() throws Exception {
    Path source = file("part.src", SOURCE);
    file("PART.DAT", "wrong");
    file("Part.dat", "wrong");
    assumeThat(folder.toFile().list()).as("the file system tells cases apart").hasSize(3);

    assertThatThrownBy(() -> controller.load(source))
        .hasMessage("it has several data lists: PART.DAT, Part.dat");
    file("part.dat", DATA);
    assertThat(controller.load(source)).isEqualTo("PART");
  }

  @Test
  void loadsASubmitProgram() throws Exception {
    controller.load(file("sps.sub", Cell.module("SPS", "MYINT=8")));
    controller.submit().select("sps");
    controller.submit().start();
    cell.cycles(1);
    assertThat(cell.get("MYINT")).isEqualTo("8");
  }

  @Test
  void loadsADataListOfTheController() throws Exception {
    assertThat(controller.load(file("$config.dat", "DEFDAT $CONFIG PUBLIC\nINT OWN=2\nENDDAT\n")))
        .isEqualTo("$CONFIG");
    assertThat(cell.get("OWN")).isEqualTo("2");
    assertThat(controller.programs()).isEmpty();
  }

  @Test
  void saysWhatIsWrongInBothFilesAndLoadsNeither() throws Exception {
    file("part.dat", "DEFDAT PART PUBLIC\nDECL GLOBAL INT SEEN=1\nINT N=\nENDDAT\n");
    Path source = file("part.src", "DEF PART()\nMYINT=\nEND\n");
    assertThatThrownBy(() -> controller.load(source))
        .isInstanceOfSatisfying(
            KrlFileException.class,
            e ->
                assertThat(e.errors())
                    .extracting(error -> error.position().file())
                    .contains("part.src", "part.dat"));
    assertThat(controller.programs()).isEmpty();
    assertThat(controller.variables().contains("SEEN")).isFalse();
  }

  @Test
  void loadsNeitherIfTheDataListDeclaresSomethingWrong() throws Exception {
    file("part.dat", "DEFDAT PART PUBLIC\nDECL GLOBAL INT SEEN=1\nINT N=TRUE\nENDDAT\n");
    Path source = file("part.src", Cell.module("PART", "MYINT=1"));
    assertThatThrownBy(() -> controller.load(source))
        .isInstanceOf(KrlFileException.class)
        .hasMessageStartingWith("part.dat:3:");
    assertThat(controller.programs()).isEmpty();
    assertThat(controller.variables().contains("SEEN")).isFalse();
  }

  @Test
  void refusesAFileThatIsNotThere() {
    Path missing = folder.resolve("nowhere").resolve("ghost.src");
    assertThatThrownBy(() -> controller.load(missing))
        .isInstanceOf(NoSuchFileException.class)
        .hasMessage(missing + ": there is no such file");
  }

  @Test
  void looksAtWhatAFileHoldsAndNotAtItsName() throws Exception {
    assertThat(controller.load(file("program", SOURCE))).isEqualTo("PART");
    assertThatThrownBy(() -> controller.load(file("notes.txt", "buy milk")))
        .isInstanceOf(KrlFileException.class)
        .hasMessageStartingWith("notes.txt:1:1:");
  }
}
