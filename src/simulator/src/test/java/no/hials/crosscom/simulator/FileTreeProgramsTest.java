package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import no.hials.crosscom.protocol.code.ProgramState;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

final class FileTreeProgramsTest {
  private Controller controller;
  private FileTree tree;
  private FileTreePrograms programs;

  @BeforeEach
  void start() throws IOException {
    controller = Cell.stepped(VariableTable.krc4());
    tree = FileTree.inMemory();
    programs = new FileTreePrograms(tree, controller.loader(), FileTreePrograms.Loaded.NOTHING);
  }

  @AfterEach
  void stop() {
    controller.close();
  }

  private static String list(int value) {
    return "DEFDAT JOB PUBLIC\nDECL GLOBAL INT G_JOB=" + value + "\nENDDAT\n";
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "/R1/JOB.SRC",
        "/R1/job",
        "/R1/JOB()",
        "/R1/Job( )",
        "KRC:\\R1\\PROGRAM\\JOB.SRC",
        "krc:/r1/program/job.dat",
        "job",
        " JOB.SRC "
      })
  void loadsAModuleWhateverFormItsNameHas(String name) throws Exception {
    tree.put("/R1/job.src", "DEF job( )\nEND\n");

    controller.robot().select(programs.prepare(name));

    assertThat(controller.robot().program())
        .hasValueSatisfying(found -> assertThat(found).isEqualToIgnoringCase("JOB"));
  }

  @Test
  void loadsTheProgramsThatAProgramCalls() throws Exception {
    tree.put("/R1/main.src", "DEF main( )\nother( )\nEND\n");
    tree.put("KRC:\\R1\\Program\\Sub\\other.src", "DEF other( )\nEND\n");

    controller.robot().select(programs.prepare("/R1/MAIN.SRC"));

    assertThat(controller.programs()).anyMatch("OTHER"::equalsIgnoreCase);
  }

  @Test
  void loadsTheNewestText() throws Exception {
    tree.put("/R1/job.src", "DEF job( )\nno_such( )\nEND\n");
    String name = programs.prepare("/R1/JOB.SRC");
    assertThat(controller.check(name)).isNotEmpty();

    tree.put("/R1/job.src", "DEF job( )\nEND\n");

    assertThat(controller.check(programs.prepare("/R1/JOB.SRC"))).isEmpty();
  }

  @Test
  void loadsADataListThatComesOrChangesAfterItsProgram() throws Exception {
    tree.put("/R1/job.src", "DEF job( )\nG_JOB=G_JOB+0\nEND\n");
    programs.prepare("/R1/JOB.SRC");
    tree.put("/R1/job.dat", list(1));

    assertThat(controller.check(programs.prepare("/R1/JOB.SRC"))).isEmpty();

    tree.put("/R1/job.dat", list(2));
    controller.robot().select(programs.prepare("/R1/JOB.SRC"));
    assertThat(controller.robot().program()).isPresent();
  }

  @Test
  void saysWhatIsWrongUntilItIsNot() throws Exception {
    tree.put("/R1/job.dat", "DEFDAT JOB\nDECL INT\nENDDAT\n");
    tree.put("/R1/job.src", "DEF job( )\nEND\n");
    tree.put("/R1/good.src", "DEF good( )\nEND\n");

    for (int i = 0; i < 2; i++) {
      assertThatExceptionOfType(KrlFileException.class)
          .isThrownBy(() -> programs.prepare("/R1/JOB.SRC"))
          .withMessageContaining("job.dat:2");
    }
    assertThat(programs.prepare("/R1/GOOD.SRC")).isEqualToIgnoringCase("GOOD");

    tree.put("/R1/job.dat", list(1));
    assertThat(programs.prepare("/R1/JOB.SRC")).isEqualToIgnoringCase("JOB");
  }

  @ParameterizedTest
  @CsvSource({
    "'DECL REAL A[1000,1000],B[1000,1000],C[1000,1000]', at most 134217728 bytes of memory",
    "'DECL INT N=TRUE', job.dat:2"
  })
  void saysWhatIsWrongWithTheDataListOfAProgram(String declaration, String message)
      throws Exception {
    tree.put("/R1/job.dat", "DEFDAT JOB\n" + declaration + "\nENDDAT\n");
    tree.put("/R1/job.src", "DEF job( )\nEND\n");
    tree.put("/R1/good.src", "DEF good( )\nEND\n");

    assertThatExceptionOfType(KrlFileException.class)
        .isThrownBy(() -> programs.prepare("/R1/JOB.SRC"))
        .withMessageContaining(message);
    assertThat(programs.prepare("/R1/GOOD.SRC")).isEqualToIgnoringCase("GOOD");
  }

  @Test
  void doesNotFindAModuleWhoseFilesWereDeleted() throws Exception {
    tree.put("/R1/job.src", "DEF job( )\nEND\n");
    programs.prepare("/R1/JOB.SRC");

    tree.delete("/R1/JOB.SRC");

    assertNotThere();
  }

  @Test
  void doesNotFindAModuleOfWhichOnlyTheDataListIsLeft() throws Exception {
    tree.put("/R1/job.src", "DEF job( )\nEND\n");
    tree.put("/R1/job.dat", list(1));
    programs.prepare("/R1/JOB.SRC");

    tree.delete("/R1/JOB.SRC");

    assertNotThere();
    tree.put("/R1/job.dat", list(2));
    assertNotThere();
    tree.put("/R1/job.src", "DEF job( )\nEND\n");
    assertThat(programs.prepare("/R1/JOB.SRC")).isEqualToIgnoringCase("JOB");
  }

  private void assertNotThere() {
    assertThatExceptionOfType(KrlFileException.class)
        .isThrownBy(() -> programs.prepare("/R1/JOB.SRC"))
        .withMessageContaining("the files of JOB have been deleted");
  }

  @Test
  void givesWhatOnlyTheControllerKnowsAsItIs() throws Exception {
    controller.load("mine.src", "DEF mine( )\nEND\n");

    controller.robot().select(programs.prepare("/R1/MINE.SRC"));

    assertThat(controller.robot().program()).isPresent();
    assertThatExceptionOfType(KrlFileException.class)
        .isThrownBy(() -> controller.robot().select(programs.prepare("/R1/NONE.SRC")))
        .withMessageContaining("no module NONE is loaded");
  }

  @Test
  void takesTheFirstOfTwoModulesOfANameThoseInTheProgramFolderBefore() throws Exception {
    tree.put("KRC:\\R1\\Mada\\job.src", "DEF job( )\nno_such( )\nEND\n");
    tree.put("/R1/PROGRAM/job.src", "DEF job( )\nEND\n");

    assertThat(controller.check(programs.prepare("JOB"))).isEmpty();
  }

  @Test
  void loadsTheListsOfTheControllerOnlyWhenTheyHaveChanged() throws Exception {
    tree.put("/R1/job.src", "DEF job( )\nEND\n");
    controller.variables().set("DEF_VEL_PTP", "42");
    programs.prepare("JOB");
    assertThat(controller.variables().get("DEF_VEL_PTP")).isEqualTo("42");

    tree.put("/R1/$config.dat", "DEFDAT $CONFIG\nINT DEF_VEL_PTP=77\nINT G_NEW=7\nENDDAT\n");
    programs.prepare("JOB");

    assertThat(controller.variables().get("DEF_VEL_PTP")).isEqualTo("77");
    assertThat(controller.variables().get("G_NEW")).isEqualTo("7");
  }

  @Test
  void loadsNoProgramThatIsLargerThanAnyReally() throws Exception {
    tree.put("/R1/job.src", "DEF job( )\n" + " ".repeat(4 << 20) + "END\n");

    assertThatExceptionOfType(KrlFileException.class)
        .isThrownBy(() -> programs.prepare("JOB"))
        .withMessageContaining("a file of KRL has at most 4194304 bytes");
  }

  @Test
  void refusesASelectionThatWouldLoadTooMuchBeforeItReadsAFile() throws Exception {
    programs = limited();
    tree.put("/R1/job.src", "DEF job( )\nEND\n");
    tree.put("/R1/large.dat", large("LARGE", 6000));
    assertThat(programs.prepare("JOB")).isEqualToIgnoringCase("JOB");
    tree.put("/R1/more.dat", large("MORE", 6000));

    assertTooMuch("JOB");
    assertThat(controller.variables().contains("G_MORE")).isFalse();

    tree.delete("/R1/more.dat");
    assertThat(programs.prepare("JOB")).isEqualToIgnoringCase("JOB");
  }

  @Test
  void countsWhatIsStillLoadedAfterItsFileWasDeletedOrGotAnotherModule() throws Exception {
    programs = limited();
    tree.put("/R1/job.src", "DEF job( )\nEND\n");
    tree.put("/R1/one.dat", large("ONE", 4000));
    programs.prepare("JOB");
    tree.put("/R1/one.dat", large("TWO", 4000));
    programs.prepare("JOB");
    tree.delete("/R1/one.dat");
    tree.put("/R1/three.dat", large("THREE", 4000));

    assertTooMuch("JOB");
  }

  @Test
  void countsAFileThatChangesOnce() throws Exception {
    programs = limited();
    for (int i = 0; i < 5; i++) {
      tree.put("/R1/job.src", "DEF job( )\n;" + i + " ".repeat(4000) + "\nEND\n");
      tree.put("/R1/job.dat", large("JOB", 4000 + i));
      assertThat(programs.prepare("JOB")).isEqualToIgnoringCase("JOB");
    }
  }

  /** Returns programs with room for 10,000 bytes more than the lists of the controller take. */
  private FileTreePrograms limited() throws IOException {
    long lists = tree.get("/R1/$config.dat").length;
    lists += tree.get("KRC:\\R1\\Mada\\$machine.dat").length;
    return new FileTreePrograms(
        tree, controller.loader(), FileTreePrograms.Loaded.NOTHING, lists + 10_000);
  }

  private static String large(String module, int bytes) {
    return "DEFDAT "
        + module
        + " PUBLIC\nDECL GLOBAL INT G_"
        + module
        + "=1\nENDDAT\n"
        + " ".repeat(bytes);
  }

  private void assertTooMuch(String name) {
    assertThatExceptionOfType(KrlFileException.class)
        .isThrownBy(() -> programs.prepare(name))
        .withMessageContaining("all programs and data lists")
        .withMessageContaining("have at most");
  }

  @Test
  void loadsTheProgramsOfThisProject() throws Exception {
    Path krl = Path.of("../../krl");
    controller.variables().load(krl.resolve("config.dat"));
    for (String name : new String[] {"actuator.src", "actuator.dat"}) {
      tree.put("KRC:\\R1\\Program\\" + name, Files.readAllBytes(krl.resolve(name)));
    }

    controller.robot().select(programs.prepare("/R1/ACTUATOR.SRC"));

    assertThat(controller.robot().state()).isEqualTo(ProgramState.RESET);
  }
}
