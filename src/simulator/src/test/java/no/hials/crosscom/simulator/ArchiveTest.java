package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.simulator.LoadReport.FileReport;
import no.hials.crosscom.simulator.LoadReport.Outcome;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

final class ArchiveTest {
  private static final Charset WINDOWS = Charset.forName("windows-1252");

  private static final String PLACE =
      """
      &ACCESS RVP
      &REL 3
      DEF PLACE( ) ;ablegen, gr\u00F6\u00DFer
      ;FOLD INI
      ;ENDFOLD
      PARTS=PARTS+COUNT
      END
      """
          .replace("\n", "\r\n");

  private static final String MAIN = "DEF MAIN( )\nPLACE()\nPARTS=PARTS+STEP\nEND\n";

  @TempDir private Path folder;

  private final VariableTable variables = VariableTable.krc4();
  private Controller controller;

  @BeforeEach
  void start() {
    controller =
        new Controller(
            variables, SimulationClock.stepped(), RobotModel.kr6r900sixx(), "archive-test");
  }

  @AfterEach
  void end() {
    controller.close();
  }

  /** Returns the files of a small cell by their places on a controller. */
  private static Map<String, byte[]> cell() throws IOException {
    Map<String, byte[]> files = new LinkedHashMap<>();
    files.put("KRC/R1/Mada/$machine.dat", list("$machine.dat"));
    files.put("KRC/R1/Mada/$robcor.dat", list("$robcor.dat"));
    files.put("KRC/STEU/Mada/$custom.dat", list("$custom.dat"));
    files.put("KRC/STEU/Mada/$option.dat", list("$option.dat"));
    files.put(
        "KRC/STEU/Mada/$machine.dat", text("DEFDAT $MACHINE PUBLIC\nINT $NUM_AX=4\nENDDAT\n"));
    files.put("KRC/R1/System/$config.dat", list("$config.dat"));
    files.put(
        "KRC/R1/System/sps.sub",
        text("DEF SPS( )\nDECL INT I\nI=1\nLOOP\nCYCLES=CYCLES+1\nENDLOOP\nEND\n"));
    files.put(
        "KRC/R1/Program/cell/globals.dat",
        text("DEFDAT GLOBALS PUBLIC\nGLOBAL INT PARTS=100\nGLOBAL INT CYCLES=0\nENDDAT\n"));
    files.put("KRC/R1/Program/cell/place.src", PLACE.getBytes(WINDOWS));
    files.put("KRC/R1/Program/cell/place.dat", text("DEFDAT PLACE\r\nINT COUNT=20\r\nENDDAT\r\n"));
    files.put("KRC/R1/Program/main.src", text(MAIN));
    files.put(
        "KRC/R1/TP/pack/main.dat", text("\uFEFFDEFDAT MAIN PUBLIC ;gr\u00F6\u00DFe\nINT STEP=3\n"));
    files.put("KRC/R1/cell.src", text("DEF CELL( )\nMAIN()\nEND\n"));
    files.put("KRC/R1/Program/readme.txt", "gr\u00FC\u00DFe".getBytes(WINDOWS));
    files.put(
        "am.ini",
        text("[Archive]\r\nName=Cell 4\r\n[Robot]\r\nSerialNo=123456\r\nVersion=8.3.35\r\n"));
    return files;
  }

  private static byte[] list(String name) throws IOException {
    try (InputStream in = ArchiveTest.class.getResourceAsStream("lists/" + name)) {
      return Objects.requireNonNull(in).readAllBytes();
    }
  }

  private static byte[] text(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private Path asFolder(Map<String, byte[]> files) throws IOException {
    for (Map.Entry<String, byte[]> file : files.entrySet()) {
      Path path = folder.resolve(file.getKey());
      Files.createDirectories(path.getParent());
      Files.write(path, file.getValue());
    }
    return folder;
  }

  private Path asZip(Map<String, byte[]> files, Charset names) throws IOException {
    Path zip = folder.resolve("cell.zip");
    try (OutputStream out = Files.newOutputStream(zip);
        ZipOutputStream entries = new ZipOutputStream(out, names)) {
      for (Map.Entry<String, byte[]> file : files.entrySet()) {
        entries.putNextEntry(new ZipEntry(file.getKey()));
        entries.write(file.getValue());
      }
    }
    return zip;
  }

  private static int firstCentralHeader(ByteBuffer zip) {
    int header = 0;
    while (zip.getInt(header) != 0x02014B50) {
      header++;
    }
    return header;
  }

  private static Map<String, byte[]> renamed(Map<String, byte[]> files, String from, String to) {
    Map<String, byte[]> renamed = new LinkedHashMap<>();
    files.forEach((name, content) -> renamed.put(name.replaceFirst(from, to), content));
    return renamed;
  }

  private LoadReport load(Path place) throws IOException {
    return controller.load(Archive.open(place), LoadingMode.LENIENT);
  }

  private static FileReport report(LoadReport report, String name) {
    return report.files().stream()
        .filter(file -> file.path().endsWith(name))
        .findFirst()
        .orElseThrow();
  }

  private void runMain() throws KrlFileException {
    controller.robot().select("MAIN");
    controller.start();
    assertThat(
            controller.stepUntil(
                () -> controller.robot().state() == ProgramState.END, Duration.ofMinutes(1)))
        .isTrue();
  }

  /** The lists of the cell have long names, and two end without ENDDAT. */
  private static void assertHasOnlyTheWarningsOfItsLists(LoadReport report) {
    assertThat(report.anyRefused()).isFalse();
    assertThat(report.problems())
        .extracting(problem -> problem.toString().toLowerCase(Locale.ROOT))
        .containsExactly(
            "$custom.dat:32:1: expected enddat, found the end of the file",
            "$config.dat:240:17: a name has at most 24 characters,"
                + " counter_of_all_parts_of_this_shift has 34",
            "$config.dat:273:29: a name has at most 24 characters,"
                + " my_energy_measuring_struc has 25",
            "main.dat:3:1: expected enddat, found the end of the file");
  }

  private void assertIsTheCell(LoadReport report) throws KrlFileException {
    assertHasOnlyTheWarningsOfItsLists(report);
    assertThat(controller.programs()).contains("PLACE", "MAIN", "CELL", "SPS");
    assertThat(variables.get("$TRAFONAME[]")).contains("SAMPLE6");
    runMain();
    assertThat(variables.get("PARTS")).isEqualTo("123");
    assertThat(controller.submit().state()).isEqualTo(ProgramState.ACTIVE);
    assertThat(Integer.parseInt(variables.get("CYCLES"))).isPositive();
  }

  @ParameterizedTest
  @ValueSource(strings = {"KRC/", "", "my cell/KRC/", "my cell/", "kRc/", "KRC/ROBOTER/KRC/"})
  void aFolderLoadsInAnyLayout(String around) throws Exception {
    assertIsTheCell(load(asFolder(renamed(cell(), "^KRC/", around))));
  }

  @ParameterizedTest
  @CsvSource({"KRC/,KRC/", "KRC/,''", "KRC/,backup/KRC/"})
  void aZipLoadsInAnyLayout(String from, String to) throws Exception {
    assertIsTheCell(load(asZip(renamed(cell(), "^" + from, to), StandardCharsets.UTF_8)));
  }

  @Test
  void namesInAnyCaseAreFound() throws Exception {
    Map<String, byte[]> files = new LinkedHashMap<>();
    cell().forEach((name, content) -> files.put(name.toUpperCase(Locale.ROOT), content));
    assertIsTheCell(load(asFolder(files)));
  }

  @Test
  void filesWithoutFoldersAreLoaded() throws Exception {
    Map<String, byte[]> files = new LinkedHashMap<>();
    cell()
        .forEach(
            (name, content) -> {
              if (!name.contains("STEU/Mada/$machine")) {
                files.put(name.substring(name.lastIndexOf('/') + 1), content);
              }
            });
    LoadReport report = load(asFolder(files));

    assertIsTheCell(report);
    FileTree tree = Archive.open(folder).tree();
    assertThat(tree.exists("KRC:\\R1\\Mada\\$machine.dat")).isTrue();
    assertThat(tree.exists("KRC:\\STEU\\Mada\\$custom.dat")).isTrue();
    assertThat(tree.exists("KRC:\\R1\\System\\sps.sub")).isTrue();
    assertThat(tree.exists("KRC:\\R1\\cell.src")).isTrue();
    assertThat(tree.exists("KRC:\\R1\\Program\\main.src")).isTrue();
  }

  @ParameterizedTest
  @CsvSource({
    "System/$config.dat,Program/main.src,cell.src,KRC:\\R1\\cell.src",
    "KRC/System/$config.dat,KRC/Program/main.src,KRC/more/my.src,KRC:\\R1\\Program\\more\\my.src",
    "KRC/first.src,KRC/second.src,KRC/more/my.src,KRC:\\R1\\Program\\more\\my.src",
    "cell/System/$config.dat,cell/TP/main.src,my.src,KRC:\\R1\\Program\\my.src"
  })
  void aProgramNextToTheFoldersOfR1IsLoaded(String list, String program, String other, String place)
      throws Exception {
    Map<String, byte[]> files = new LinkedHashMap<>();
    files.put(list, text(list.endsWith(".dat") ? "DEFDAT $CONFIG\nENDDAT\n" : "DEF C( )\nEND\n"));
    files.put(program, text("DEF D( )\nEND\n"));
    files.put(other, text("DEF MY( )\nEND\n"));

    assertThat(load(asFolder(files)).problems()).isEmpty();
    assertThat(controller.programs()).contains("MY");
    assertThat(Archive.open(folder).tree().exists(place)).isTrue();
  }

  @Test
  void aProgramNextToR1IsNotLoadedAndTheReportSaysSo() throws Exception {
    Map<String, byte[]> files = cell();
    files.put("old/main.src", text("DEF MAIN( )\nPARTS=0\nEND\n"));
    files.put("KRC/Roboter/Template/vorgabe.src", text("DEF VORGABE( )\nEND\n"));

    LoadReport report = load(asFolder(files));

    assertThat(report(report, "old/main.src").outcome()).isEqualTo(Outcome.REFUSED);
    assertThat(report(report, "old/main.src").problems().get(0).message())
        .isEqualTo("not loaded: it is not in R1 or STEU as other files are");
    assertThat(controller.programs()).doesNotContain("VORGABE");
    runMain();
    assertThat(variables.get("PARTS")).isEqualTo("123");
  }

  @Test
  void aCopyInAFolderOfAFolderDoesNotReplaceTheProgram() throws Exception {
    Map<String, byte[]> files = cell();
    files.put("KRC/R1/Program/backup/main.src", text("DEF MAIN( )\nPARTS=0\nEND\n"));

    LoadReport report = load(asFolder(files));

    assertThat(report(report, "backup/main.src").problems().get(0).message())
        .isEqualTo("another file of this name is loaded: KRC/R1/Program/main.src");
    runMain();
    assertThat(variables.get("PARTS")).isEqualTo("123");
  }

  @Test
  void aCopyOfAProgramDoesNotReplaceTheFileWithTheNameOfTheModule() throws Exception {
    Map<String, byte[]> files = cell();
    files.put("KRC/R1/Program/Copy of main.src", text("DEF MAIN( )\nPARTS=0\nEND\n"));
    files.put("KRC/R1/Program/z_main.src", text("DEF MAIN( )\nPARTS=0\nEND\n"));
    files.put("KRC/R1/Program/z_main.dat", text("DEFDAT MAIN PUBLIC\nINT STEP=7\nENDDAT\n"));
    files.put("KRC/R1/Program/alone_1.src", text("DEF ALONE( )\nEND\n"));
    files.put("KRC/R1/Program/alone_2.src", text("DEF ALONE( )\nEND\n"));

    LoadReport report = load(asFolder(files));

    assertThat(report.files().stream().filter(file -> file.outcome() == Outcome.REFUSED))
        .extracting(file -> file.path() + ": " + file.problems().get(0).message())
        .containsExactlyInAnyOrder(
            "KRC/R1/Program/Copy of main.src: another file has its module MAIN, and is loaded:"
                + " KRC/R1/Program/main.src",
            "KRC/R1/Program/z_main.src: another file has its module MAIN, and is loaded:"
                + " KRC/R1/Program/main.src",
            "KRC/R1/Program/z_main.dat: another file has its module MAIN, and is loaded:"
                + " KRC/R1/TP/pack/main.dat",
            "KRC/R1/Program/alone_2.src: another file has its module ALONE, and is loaded:"
                + " KRC/R1/Program/alone_1.src");
    runMain();
    assertThat(variables.get("PARTS")).isEqualTo("123");
  }

  @Test
  void modulesOfKssWithoutFoldersAreProgramsUnlessTheyAreDataLists() throws Exception {
    byte[] program = text("DEF $tt_own( )\nEND\n");
    FileTree tree =
        Archive.open(asFolder(Map.of("$tt_own.src", program, "$option.dat", list("$option.dat"))))
            .tree();

    assertThat(tree.get("KRC:\\R1\\Program\\$tt_own.src")).isEqualTo(program);
    assertThat(tree.exists("KRC:\\STEU\\Mada\\$option.dat")).isTrue();
  }

  @Test
  void theMachineDataOfR1CountNotThoseOfSteu() throws Exception {
    load(asFolder(cell()));

    assertThat(variables.get("$NUM_AX")).isEqualTo("6");
  }

  @Test
  void theTreeHasTheFilesByteForByteAndWritesDoNotReachTheArchive() throws Exception {
    Map<String, byte[]> files = cell();
    Path place = asFolder(files);
    FileTree tree = Archive.open(place).tree();

    for (Map.Entry<String, byte[]> file : files.entrySet()) {
      String name = "KRC:\\" + file.getKey().replaceFirst("^KRC/", "").replace('/', '\\');
      assertThat(tree.get(name)).as(name).isEqualTo(file.getValue());
    }
    tree.put("KRC:\\R1\\Program\\main.src", "changed");
    assertThat(Files.readAllBytes(place.resolve("KRC/R1/Program/main.src"))).isEqualTo(text(MAIN));
  }

  @Test
  void amIniNamesTheRobot() throws Exception {
    assertThat(Archive.open(asFolder(cell())).description())
        .hasValue("name Cell 4, serial 123456, version 8.3.35");
    assertThat(Archive.open(folder.resolve("KRC/R1/cell.src")).description()).isEmpty();
  }

  @Test
  void aFileWithErrorsIsLoadedWithWarningsOrRefused() throws Exception {
    Map<String, byte[]> files = cell();
    files.put("KRC/R1/Program/bad.src", text("DEF BAD( )\nPARTS=\nPARTS=7\nEND\n"));
    Path place = asFolder(files);

    FileReport lenient = report(load(place), "bad.src");
    assertThat(lenient.path()).isEqualTo("KRC/R1/Program/bad.src");
    assertThat(lenient.outcome()).isEqualTo(Outcome.WARNINGS);
    assertThat(lenient.problems().get(0).position().line()).isEqualTo(2);

    start();
    LoadReport strict = controller.load(Archive.open(place), LoadingMode.STRICT);
    assertThat(report(strict, "bad.src").outcome()).isEqualTo(Outcome.REFUSED);
    assertThat(controller.programs()).doesNotContain("BAD").contains("MAIN");
  }

  @Test
  void aMissingRoutineIsAWarningOfTheFile() throws Exception {
    Map<String, byte[]> files = cell();
    files.put("KRC/R1/Program/weld.src", text("DEF WELD( )\nTORCH_ON()\nEND\n"));

    FileReport report = report(load(asFolder(files)), "weld.src");

    assertThat(report.outcome()).isEqualTo(Outcome.WARNINGS);
    assertThat(report.problems().get(0).toString()).startsWith("weld.src:2:1").contains("TORCH_ON");
  }

  @Test
  void anUnknownSystemVariableIsOneWarningOfTheArchive() throws Exception {
    Map<String, byte[]> files = cell();
    files.put("KRC/R1/Program/a.src", text("DEF A( )\n$SEEN=1\n$SEEN=2\n$OTHER=$SEEN\nEND\n"));
    files.put("KRC/R1/Program/b.src", text("DEF B( )\nPARTS=$SEEN\n$MORE=1\nA( )\nEND\n"));

    LoadReport report = load(asFolder(files));

    assertThat(report.problems())
        .extracting(KrlError::toString)
        .filteredOn(problem -> problem.contains(" is not known; it keeps what is written to it"))
        .extracting(problem -> problem.substring(0, problem.indexOf(" is")))
        .containsExactly(
            "a.src:2:1: the system variable $SEEN",
            "a.src:4:1: the system variable $OTHER",
            "b.src:3:1: the system variable $MORE");
  }

  @Test
  void ofTwoFilesOfOneNameThatInProgramIsLoaded() throws Exception {
    Map<String, byte[]> files = cell();
    files.put("KRC/R1/TP/other/main.src", text("DEF MAIN( )\nPARTS=0\nEND\n"));

    LoadReport report = load(asFolder(files));

    assertThat(report(report, "other/main.src").outcome()).isEqualTo(Outcome.REFUSED);
    assertThat(report(report, "other/main.src").problems().get(0).message())
        .contains("KRC/R1/Program/main.src");
    runMain();
    assertThat(variables.get("PARTS")).isEqualTo("123");
  }

  @ParameterizedTest
  @CsvSource({"A10_INI,LENIENT", "ZZ_INI,LENIENT", "A10_INI,STRICT", "ZZ_INI,STRICT"})
  void aListImportsFromAListWithoutProgram(String from, LoadingMode mode) throws Exception {
    Map<String, byte[]> files = new LinkedHashMap<>();
    files.put("main.src", text("DEF MAIN( )\nDEPTH=START_COND[2]\nSTEP( )\nEND\n"));
    files.put("step.src", text("DEF STEP( )\nSTART_COND[2]=6\nDEPTH=DEPTH+START_COND[2]\nEND\n"));
    String imported = "IMPORT INT START_COND[] IS /R1/" + from + "..START_COND\nENDDAT\n";
    files.put("main.dat", text("DEFDAT MAIN\n" + imported));
    files.put("step.dat", text("DEFDAT STEP\n" + imported));
    files.put(
        from + ".dat",
        text("DEFDAT " + from + " PUBLIC\nDECL INT START_COND[4]\nSTART_COND[2]=30\nENDDAT\n"));
    files.put("out.dat", text("DEFDAT OUT PUBLIC\nGLOBAL INT DEPTH=0\nENDDAT\n"));

    LoadReport report = controller.load(Archive.open(asFolder(files)), mode);

    assertThat(report.problems()).isEmpty();
    assertThat(controller.programs()).doesNotContain(from);
    runMain();
    assertThat(variables.get("DEPTH")).isEqualTo("36");
  }

  @ParameterizedTest
  @CsvSource({
    "DEFDAT A10_INI, IMPORT needs a public data list",
    "DEFDAT OTHER PUBLIC, no module A10_INI with a variable START_COND"
  })
  void anImportThatFindsNothingIsOneProblem(String head, String problem) throws Exception {
    Map<String, byte[]> files = new LinkedHashMap<>();
    files.put("out.dat", text("DEFDAT OUT PUBLIC\nGLOBAL INT DEPTH=0\nENDDAT\n"));
    files.put(
        "main.src",
        text("DEF MAIN( )\nDEPTH=1\nMORE( )\nDEPTH=START_COND[2]\nEND\nDEF MORE( )\nEND\n"));
    files.put(
        "main.dat",
        text("DEFDAT MAIN\nIMPORT INT START_COND[] IS /R1/A10_INI..START_COND\nENDDAT\n"));
    files.put("ini.dat", text(head + "\nDECL INT START_COND[4]\nENDDAT\n"));
    Archive archive = Archive.open(asFolder(files));

    assertThat(controller.load(archive, LoadingMode.LENIENT).problems())
        .singleElement()
        .asString()
        .startsWith("main.dat:2:1: " + problem);
    controller.robot().select("MAIN");
    controller.start();
    assertThat(
            controller.stepUntil(
                () -> controller.robot().state() == ProgramState.STOP, Duration.ofMinutes(1)))
        .isTrue();
    assertThat(variables.get("DEPTH")).isEqualTo("1");
    assertThat(variables.get("$ERR.NUMBER")).isEqualTo("9010");

    controller.close();
    start();
    controller.load(archive, LoadingMode.STRICT);
    assertThatThrownBy(() -> controller.robot().select("MAIN"))
        .isInstanceOf(KrlFileException.class)
        .hasMessageStartingWith("main.dat:2:1: " + problem);
  }

  @Test
  void aListMayUseTheTypesOfALaterOne() throws Exception {
    Map<String, byte[]> files = cell();
    files.put(
        "KRC/R1/Program/a_parts.dat",
        text("DEFDAT A_PARTS PUBLIC\nDECL GLOBAL SLOT_T FIRST={NO 4}\nENDDAT\n"));
    files.put(
        "KRC/R1/Program/z_types.dat",
        text("DEFDAT Z_TYPES PUBLIC\nGLOBAL STRUC SLOT_T INT NO\nENDDAT\n"));

    assertHasOnlyTheWarningsOfItsLists(load(asFolder(files)));
    assertThat(variables.get("FIRST.NO")).isEqualTo("4");
  }

  @Test
  void aTypeThatAModuleReplacesIsAWarning() throws Exception {
    Map<String, byte[]> files = cell();
    files.put(
        "KRC/R1/Program/a_types.dat",
        text("DEFDAT A_TYPES PUBLIC\nGLOBAL STRUC SLOT_T INT NO\nENDDAT\n"));
    files.put(
        "KRC/R1/Program/b_types.dat",
        text("DEFDAT B_TYPES PUBLIC\nGLOBAL STRUC SLOT_T INT NO,REAL X\nENDDAT\n"));

    LoadReport report = load(asFolder(files));

    assertThat(report(report, "b_types.dat").problems())
        .extracting(KrlError::message)
        .containsExactly("type SLOT_T is known with other parts; this declaration replaces it");
  }

  @Test
  void eachModuleUsesItsOwnOfTwoGlobalVariables() throws Exception {
    Map<String, byte[]> files = cell();
    for (String name : List.of("A1", "B1")) {
      String list = "DEFDAT %s PUBLIC\nDECL GLOBAL INT STEP_OF=%d\nENDDAT\n";
      files.put(
          "KRC/R1/Program/" + name + ".dat", text(list.formatted(name, name.charAt(0) - 'A')));
      files.put(
          "KRC/R1/Program/" + name + ".src",
          text("DEF %s( )\nPARTS=PARTS+10*(STEP_OF+1)\nEND\n".formatted(name)));
    }
    files.put("KRC/R1/Program/main.src", text("DEF MAIN( )\nPARTS=0\nA1()\nB1()\nEND\n"));

    LoadReport report = load(asFolder(files));

    assertThat(report(report, "B1.dat").problems())
        .extracting(KrlError::message)
        .containsExactly("STEP_OF is GLOBAL in A1, too; this one is only for module B1");
    runMain();
    assertThat(variables.get("PARTS")).isEqualTo("30");
    assertThat(variables.get("STEP_OF")).isEqualTo("0");
  }

  @Test
  void aVariableOfTheControllerIsNotReplacedByOneOfAModule() throws Exception {
    Map<String, byte[]> files = cell();
    files.put("KRC/R1/System/$config.dat", text("DEFDAT $CONFIG\nINT SHARED=1\nENDDAT\n"));
    files.put(
        "KRC/R1/Program/other.dat",
        text("DEFDAT OTHER PUBLIC\nDECL GLOBAL INT SHARED=77\nENDDAT\n"));

    LoadReport report = load(asFolder(files));

    assertThat(report(report, "other.dat").problems())
        .extracting(KrlError::message)
        .containsExactly("SHARED is GLOBAL in $CONFIG, too; this one is only for module OTHER");
    assertThat(variables.get("SHARED")).isEqualTo("1");
  }

  @Test
  void ofTwoGlobalRoutinesThatOfTheModuleOfItsNameIsCalled() throws Exception {
    Map<String, byte[]> files = cell();
    files.put("KRC/R1/Program/main.src", text("DEF MAIN( )\nPARTS=0\nSUBM()\nEND\n"));
    files.put("KRC/R1/Program/subm.src", text("DEF SUBM( )\nPARTS=5\nEND\n"));
    files.put(
        "KRC/R1/Program/two.src", text("DEF TWO( )\nEND\nGLOBAL DEF SUBM( )\nPARTS=6\nEND\n"));

    LoadReport report = load(asFolder(files));

    assertThat(
            report.files().stream()
                .flatMap(file -> file.problems().stream())
                .map(KrlError::message))
        .containsAnyOf(
            "routine SUBM is also in module TWO; other modules call that of SUBM",
            "routine SUBM is also in module SUBM; other modules call that of SUBM");
    runMain();
    assertThat(variables.get("PARTS")).isEqualTo("5");
  }

  // hostile and odd zips

  @ParameterizedTest
  @ValueSource(strings = {"KRC/R1/../../../evil.src", "../../evil.src", "/KRC/R1/evil.src"})
  void aPathOutOfTheZipIsRefused(String path) throws Exception {
    Map<String, byte[]> files = cell();
    files.put(path, text("DEF EVIL( )\nEND\n"));

    LoadReport report = load(asZip(files, StandardCharsets.UTF_8));

    assertThat(report.toString())
        .contains(
            path
                + " REFUSED\n"
                + "  evil.src:1:1: the path of a file in a zip is relative and has no .., is "
                + path);
    assertThat(controller.programs()).doesNotContain("EVIL").contains("MAIN");
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void filesAndFoldersWhoseNamesBeginWithADotAreLeftOut(boolean zip) throws Exception {
    Map<String, byte[]> files = cell();
    files.put(".git/R1/Program/hid.src", text("DEF HID( )\nEND\n"));
    files.put("KRC/R1/Program/.hid2.src", text("DEF HID2( )\nEND\n"));

    LoadReport report = load(zip ? asZip(files, StandardCharsets.UTF_8) : asFolder(files));

    assertThat(report.files()).extracting(FileReport::path).noneMatch(path -> path.contains("hid"));
    assertThat(controller.programs()).doesNotContain("HID", "HID2").contains("MAIN");
  }

  @Test
  void aFileThatUnpacksToTooMuchIsRefusedAndTheRestCounts() throws Exception {
    Map<String, byte[]> files = cell();
    files.put("KRC/R1/Program/huge.src", new byte[(32 << 20) + 1]);
    Path zip = asZip(files, StandardCharsets.UTF_8);
    assertThat(Files.size(zip)).isLessThan(1 << 20);

    LoadReport report = load(zip);

    assertThat(report(report, "huge.src").problems().get(0).message())
        .isEqualTo("a file has at most 33554432 bytes, has more");
    assertThat(controller.programs()).contains("MAIN");
  }

  @Test
  void aTruncatedFileIsRefusedAndTheRestIsLoaded() throws Exception {
    Map<String, byte[]> files = new LinkedHashMap<>();
    files.put("KRC/R1/Program/cut.src", text("DEF CUT( )\n" + "PARTS=1\n".repeat(50) + "END\n"));
    files.putAll(cell());
    Path zip = asZip(files, StandardCharsets.UTF_8);
    ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(zip)).order(ByteOrder.LITTLE_ENDIAN);
    bytes.putInt(firstCentralHeader(bytes) + 20, 5); // the compressed size
    Files.write(zip, bytes.array());

    LoadReport report = load(zip);

    assertThat(report(report, "cut.src").problems().get(0).message())
        .startsWith("the zip is damaged");
    assertThat(controller.programs()).doesNotContain("CUT").contains("MAIN");
  }

  @Test
  void aZipWithAnUnsupportedMethodIsNotCalledDamaged() throws Exception {
    Map<String, byte[]> files = new LinkedHashMap<>();
    files.put("KRC/R1/Program/bzip.src", text("DEF BZIP( )\nEND\n"));
    files.putAll(cell());
    Path zip = asZip(files, StandardCharsets.UTF_8);
    ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(zip)).order(ByteOrder.LITTLE_ENDIAN);
    bytes.putShort(firstCentralHeader(bytes) + 10, (short) 12); // the method, bzip2
    Files.write(zip, bytes.array());

    assertThatThrownBy(() -> load(zip))
        .isInstanceOf(IOException.class)
        .hasMessageEndingWith(
            "the zip has a compression method that is not supported; stored and deflated are");
  }

  @Test
  void aFileOfTwoArchivesIsNamedWithBoth() throws Exception {
    Path first = Files.createDirectory(folder.resolve("first"));
    Path second = Files.createDirectory(folder.resolve("second"));
    Files.writeString(first.resolve("a.src"), "DEF A( )\nEND\n");
    Files.writeString(second.resolve("a.src"), "DEF A( )\nEND\n");

    LoadReport report = controller.load(Archive.open(List.of(first, second)), LoadingMode.LENIENT);

    assertThat(report.problems().get(0).message())
        .isEqualTo(
            "the file of "
                + second
                + " is not used: the archive has it already, as a.src of "
                + first);
  }

  @Test
  void aFileWithAWrongChecksumIsRefusedAndTheRestIsLoaded() throws Exception {
    Map<String, byte[]> files = new LinkedHashMap<>();
    files.put("KRC/R1/Program/bit.src", text("DEF BIT( )\nPARTS=1\nEND\n"));
    files.putAll(cell());
    Path zip = asZip(files, StandardCharsets.UTF_8);
    ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(zip)).order(ByteOrder.LITTLE_ENDIAN);
    int checksum = firstCentralHeader(bytes) + 16;
    bytes.putInt(checksum, bytes.getInt(checksum) ^ 1);
    Files.write(zip, bytes.array());

    LoadReport report = load(zip);

    assertThat(report(report, "bit.src").problems().get(0).message())
        .isEqualTo("the zip is damaged: the checksum of the file is wrong");
    assertThat(controller.programs()).doesNotContain("BIT").contains("MAIN");
  }

  @Test
  void theReportNamesFilesThatClientsCannotSee() throws Exception {
    Map<String, byte[]> files = cell();
    files.put("KRC/R1/Program/aux.src", text("DEF AUX( )\nEND\n"));
    files.put("KRC/R1/Program/" + "x".repeat(300) + ".txt", text("notes"));

    LoadReport report = load(asZip(files, StandardCharsets.UTF_8));

    assertThat(report(report, "aux.src").problems().get(0).message())
        .isEqualTo("not among the files of C3 Bridge: \"aux.src\" cannot be the name of a file");
    assertThat(report(report, "aux.src").module()).isEqualTo("AUX");
    assertThat(report(report, "xxx.txt").outcome()).isEqualTo(Outcome.WARNINGS);
    assertThat(report(report, "xxx.txt").problems().get(0).message())
        .startsWith("not among the files of C3 Bridge: a full name has at most 259 characters");
  }

  @Test
  void namesOfAnOldZipAreInItsCodePage() throws Exception {
    Map<String, byte[]> files = cell();
    files.put("KRC/R1/Program/gr\u00FC\u00DFe.src", text("DEF HELLO( )\nEND\n"));

    FileTree tree = Archive.open(asZip(files, Charset.forName("IBM437"))).tree();

    assertThat(tree.exists("KRC:\\R1\\Program\\gr\u00FC\u00DFe.src")).isTrue();
  }

  @Test
  void aMissingOrDamagedArchiveIsAnError() throws Exception {
    assertThatThrownBy(() -> Archive.open(folder.resolve("no.zip")))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("there is no such file");
    Path damaged = Files.write(folder.resolve("damaged.zip"), new byte[] {'P', 'K', 3, 4, 0, 0});
    assertThatThrownBy(() -> Archive.open(damaged))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("damaged.zip: the zip is damaged or incomplete: ");
  }

  @Test
  void anEncryptedZipIsAnError() throws Exception {
    Path zip = asZip(cell(), StandardCharsets.UTF_8);
    ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(zip)).order(ByteOrder.LITTLE_ENDIAN);
    int header = firstCentralHeader(bytes);
    bytes.putShort(header + 8, (short) (bytes.getShort(header + 8) | 1)); // the flags
    Files.write(zip, bytes.array());

    assertThatThrownBy(() -> Archive.open(zip))
        .isInstanceOf(IOException.class)
        .hasMessageEndingWith("cell.zip: the zip is encrypted");
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void anArchiveWithoutProgramsAndDataListsIsAnError(boolean zip) throws Exception {
    for (Map<String, byte[]> files :
        List.<Map<String, byte[]>>of(Map.of(), Map.of("KRC/R1/readme.txt", text("notes")))) {
      Path place = zip ? asZip(files, StandardCharsets.UTF_8) : asFolder(files);
      assertThatThrownBy(() -> Archive.open(place))
          .isInstanceOf(IOException.class)
          .hasMessage(place + ": there is no .src, .sub or .dat file in it");
    }
  }

  @Test
  void aFileThatIsNeitherAZipNorOfKrlIsAnError() throws Exception {
    Path file = Files.write(folder.resolve("cell.zip"), new byte[] {1, 2, 3, 4, 5});

    assertThatThrownBy(() -> Archive.open(file))
        .isInstanceOf(IOException.class)
        .hasMessage(file + ": it is neither a zip nor a .src, .sub or .dat file");
  }

  @Test
  void aProgramOfTheTreeIsNotLoadedAgainByItsSelectionButAChangedOneIs() throws Exception {
    Archive archive = Archive.open(asFolder(cell()));
    controller.load(archive, LoadingMode.LENIENT);
    FileTree tree = archive.tree();
    controller.connect(tree);

    assertThat(controller.loadFromFiles("/R1/MAIN.SRC")).isEqualTo("MAIN");
    runMain();
    assertThat(controller.loadFromFiles("/R1/MAIN.SRC")).isEqualTo("MAIN");
    runMain();
    assertThat(variables.get("PARTS")).as("the lists were not loaded again").isEqualTo("146");

    tree.put("/R1/MAIN.SRC", "DEF MAIN( )\nPARTS=5\nUNKNOWN WORD\nEND\n");
    assertThat(controller.loadFromFiles("/R1/MAIN.SRC")).as("lenient too").isEqualTo("MAIN");
  }

  @Test
  void anArchiveMayBeLargerThanWhatClientsMayWrite() throws Exception {
    Map<String, byte[]> files = cell();
    String line = ";" + "x".repeat(1000) + "\n";
    files.put("KRC/R1/Program/long.src", text("DEF LONG( )\n" + line.repeat(10_000) + "END\n"));
    Archive archive = Archive.open(asFolder(files));
    assertHasOnlyTheWarningsOfItsLists(controller.load(archive, LoadingMode.LENIENT));
    FileTree tree = archive.tree();
    controller.connect(tree);

    assertThat(controller.loadFromFiles("LONG")).isEqualTo("LONG");
    assertThat(controller.loadFromFiles("MAIN")).isEqualTo("MAIN");
    tree.put("/R1/OTHER.SRC", "DEF OTHER( )\n" + line.repeat(5000) + "END\n");
    assertThatThrownBy(() -> controller.loadFromFiles("OTHER"))
        .hasMessageContaining("a file of KRL has at most 4194304 bytes");
  }

  @Test
  void severalPlacesAreOneArchive() throws Exception {
    asFolder(cell());
    Path other = Files.writeString(folder.resolve("more.src"), "DEF MORE( )\nMAIN()\nEND\n");

    LoadReport report =
        controller.load(Archive.open(List.of(folder.resolve("KRC"), other)), LoadingMode.LENIENT);

    assertHasOnlyTheWarningsOfItsLists(report);
    assertThat(controller.programs()).contains("MORE", "MAIN");
  }
}
