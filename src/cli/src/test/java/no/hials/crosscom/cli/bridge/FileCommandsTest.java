package no.hials.crosscom.cli.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.file.FileRequest.CopyFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.DeleteFileRequest;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code file ls}, {@code stat}, {@code cp}, {@code mv} and {@code rm}. */
class FileCommandsTest {
  private static final String TIME = "\\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d:\\d\\d";

  @KukaController(server = ServerType.C3_BRIDGE)
  private MockServer server;

  @BeforeEach
  void start() throws IOException {
    server.files().put("KRC:\\R1\\Program\\A.SRC", "DEF A ( )\nEND\n");
    server.files().put("KRC:\\R1\\Program\\b.txt", "12345");
  }

  private Cli.Result run(String command, String... args) {
    return Cli.runOn(server, command, args);
  }

  // ls

  @ParameterizedTest
  @ValueSource(
      strings = {"KRC:\\R1\\PROGRAM", "KRC:\\R1\\PROGRAM\\", "/R1/Program", "/r1/program/"})
  void listsAFolderInEveryFormOfItsName(String folder) {
    run("file ls", folder)
        .succeeds()
        .containsExactly(
            "TYPE    SIZE  ATTRIBUTES  NAME",
            "module    14  archive     A.SRC",
            "text       5  archive     b.txt");
  }

  @Test
  void listsTheFolderOfTheRobotIfNoneIsGiven() {
    assertThat(run("file ls").lines())
        .containsExactly(
            "TYPE       SIZE  ATTRIBUTES  NAME",
            "directory  -     -           Mada",
            "directory  -     -           Program",
            "directory  -     -           System",
            "directory  -     -           TP");
  }

  @Test
  void listsTimesIfTheyAreWanted() {
    assertThat(run("file ls", "-l", "/R1/Program").lines())
        .hasSize(3)
        .last()
        .asString()
        .matches("text +5  " + TIME + "  archive     b.txt");
  }

  @Test
  void listsAsJson() throws IOException {
    server.files().put("/R1/\u00e4\u4e2d.TXT", "");

    assertThat(run("file ls", "--json", "KRC:\\R1\\Program").lines())
        .contains(
            "{\"name\":\"b.txt\",\"path\":\"KRC:\\\\R1\\\\Program\\\\b.txt\",\"type\":\"text\","
                + "\"size\":5,\"attributes\":[\"archive\"]}")
        .anyMatch(line -> line.startsWith("{\"name\":\"\\u00E4\\u4E2D.TXT\""));
    assertThat(run("file ls", "--json", "-l").lines().get(0))
        .startsWith("{\"name\":\"Mada\"")
        .contains("\"size\":null,\"attributes\":[],\"created\":\"20")
        .endsWith("Z\"}");
  }

  @Test
  void listsNamesOnlyIfMoreDoesNotFitIntoAnAnswer() throws IOException {
    for (int i = 1000; i < 2800; i++) {
      server.files().put("KRC:\\R1\\TP\\FILE" + i + ".TXT", "");
    }

    Cli.Result result = run("file ls", "KRC:\\R1\\TP");

    assertThat(result.lines()).hasSize(1801).contains("-     -     -           FILE1000.TXT");
  }

  @Test
  void asksForOneTypeAfterTheOtherIfTheNamesDoNotFitEither() throws IOException {
    for (int i = 1000; i < 2800; i++) {
      server.files().put("KRC:\\R1\\TP\\FILE" + i + ".TXT", "");
      server.files().put("KRC:\\R1\\TP\\FILE" + i + ".ZIP", "");
    }

    Cli.Result result = run("file ls", "KRC:\\R1\\TP");

    assertThat(result.lines()).hasSize(3601).anyMatch(line -> line.matches("text .* FILE2799.TXT"));
    assertThat(result.errLines())
        .singleElement()
        .asString()
        .startsWith("the list is too long for one answer");
    assertThat(result.code()).isZero();
  }

  @ParameterizedTest
  @ValueSource(strings = {"KRC:\\R1\\NOPE", "/R1/A.SRC"})
  void saysThatItCannotList(String name) {
    Cli.Result result = run("file ls", name);

    result.fails(1);
    assertThat(result.errLines().get(0))
        .startsWith("jopenshowvar: the server refused the listing of " + name + ": code ");
  }

  // stat

  @Test
  void printsWhatIsKnownOfAFile() {
    Cli.Result result = run("file stat", "/R1/A.SRC");

    assertThat(result.out())
        .containsPattern("(?m)^name +A.SRC$")
        .containsPattern("(?m)^path +KRC:\\\\R1\\\\PROGRAM\\\\A.SRC$")
        .containsPattern("(?m)^KRC name +/R1/A.SRC$")
        .containsPattern("(?m)^type +module$")
        .containsPattern("(?m)^size +14$")
        .containsPattern("(?m)^attributes +archive$")
        .containsPattern("(?m)^modified +" + TIME + "$")
        .containsPattern("(?m)^edit mode +full$");
    assertThat(result.code()).isZero();
  }

  @Test
  void printsTheOthersIfOneIsNotThere() {
    Cli.Result result = run("file stat", "/R1/NOPE", "/R1/b.txt", "--json");

    assertThat(result.lines())
        .singleElement()
        .asString()
        .startsWith(
            "{\"name\":\"b.txt\",\"path\":\"KRC:\\\\R1\\\\PROGRAM\\\\B.TXT\",\"krcName\":\"/R1/B.TXT\","
                + "\"type\":\"text\",\"size\":5,\"attributes\":[\"archive\"],\"created\":\"20")
        .endsWith("\"editMode\":\"full\"}");
    assertThat(result.errLines())
        .containsExactly(
            "jopenshowvar: the server refused the request for the properties of /R1/NOPE:"
                + " code 0 (GENERAL: no reason given)",
            "likely cause: file or folder not found");
    assertThat(result.code()).isEqualTo(1);
  }

  // cp and mv

  @Test
  void copiesToANameAndIntoAFolder() {
    assertThat(run("file cp", "/R1/A.SRC", "/R1/C.SRC").lines())
        .containsExactly("/R1/A.SRC -> /R1/C.SRC");
    assertThat(run("file cp", "/R1/A.SRC", "KRC:\\R1\\TP").lines())
        .containsExactly("/R1/A.SRC -> KRC:\\R1\\TP\\A.SRC");

    assertThat(server.files().text("KRC:\\R1\\TP\\A.SRC")).hasValue("DEF A ( )\nEND\n");
    assertThat(server.files().exists("KRC:\\R1\\Program\\C.SRC")).isTrue();
  }

  @Test
  void movesAFile() {
    assertThat(run("file mv", "/R1/b.txt", "/R1/d.txt", "--json").lines())
        .containsExactly("{\"command\":\"mv\",\"source\":\"/R1/b.txt\",\"name\":\"/R1/d.txt\"}");

    assertThat(server.files().exists("/R1/b.txt")).isFalse();
    assertThat(server.files().text("/R1/d.txt")).hasValue("12345");
  }

  @ParameterizedTest
  @CsvSource({"cp,copy", "mv,move"})
  void overwritesOnlyIfToldTo(String command, String verb) {
    run("file " + command, "/R1/A.SRC", "/R1/b.txt")
        .failsInLines(5)
        .containsExactly(
            "jopenshowvar: did not "
                + verb
                + " /R1/A.SRC to /R1/b.txt: /R1/b.txt already exists, which needs --yes");
    assertThat(server.requests()).noneMatch(each -> each.request() instanceof CopyFileRequest);

    assertThat(run("file " + command, "/R1/A.SRC", "/R1/b.txt", "--yes").code()).isZero();
    assertThat(server.files().text("/R1/b.txt")).hasValue("DEF A ( )\nEND\n");
  }

  // rm

  @Test
  void deletesOnlyIfToldTo() {
    run("file rm", "/R1/A.SRC", "/R1/b.txt")
        .failsInLines(5)
        .containsExactly(
            "jopenshowvar: did not delete /R1/A.SRC, /R1/b.txt: deleting cannot be undone, which"
                + " needs --yes");
    assertThat(server.requests()).noneMatch(each -> each.request() instanceof DeleteFileRequest);

    assertThat(run("file rm", "--yes", "/R1/A.SRC", "/R1/b.txt").lines())
        .containsExactly("deleted /R1/A.SRC", "deleted /R1/b.txt");
    assertThat(server.files().exists("/R1/A.SRC")).isFalse();
  }

  @Test
  void deletesAModuleByItsName() throws IOException {
    server.files().put("KRC:\\R1\\Program\\A.DAT", "DEFDAT A\nENDDAT\n");

    run("file rm", "--yes", "/R1/A").succeeds().containsExactly("deleted /R1/A");

    assertThat(server.files().exists("/R1/A.SRC")).isFalse();
    assertThat(server.files().exists("/R1/A.DAT")).isFalse();
  }

  @Test
  void deletesNothingIfOneIsNotThere() {
    run("file rm", "--yes", "/R1/A.SRC", "/R1/NOPE")
        .failsInLines(1)
        .hasSize(2)
        .last()
        .asString()
        .contains("file or folder not found");
    assertThat(server.files().exists("/R1/A.SRC")).isTrue();
  }

  @Test
  void deletesAFolderOnlyIfToldTo() throws IOException {
    server.files().put("KRC:\\R1\\Old\\X.SRC", "");

    run("file rm", "--yes", "KRC:\\R1\\Old")
        .fails(5)
        .contains("it is a folder, which needs --recursive");

    assertThat(run("file rm", "-r", "KRC:\\R1\\Old").err())
        .contains("the content of KRC:\\R1\\Old will be deleted, too, which needs --yes");
    assertThat(server.files().exists("KRC:\\R1\\Old\\X.SRC")).isTrue();

    assertThat(run("file rm", "-r", "--yes", "KRC:\\R1\\Old", "--json").lines())
        .containsExactly("{\"command\":\"rm\",\"name\":\"KRC:\\\\R1\\\\Old\"}");
    assertThat(server.files().exists("KRC:\\R1\\Old")).isFalse();
  }

  @Test
  void saysWhichFilesAreLeftIfTheConnectionIsLost() {
    server.fault(each -> each.request() instanceof DeleteFileRequest, Fault.closeBefore());

    Cli.Result result = run("file rm", "--yes", "/R1/A.SRC", "/R1/b.txt");

    result.failsInLines(4).last().isEqualTo("not deleted: /R1/b.txt");
    assertThat(result.errLines().get(0)).contains("the outcome is unknown");
  }

  // all of them

  @ParameterizedTest
  @ValueSource(strings = {"cp /R1/A.SRC /R1/C.SRC", "mv /R1/A.SRC /R1/C.SRC", "rm /R1/A.SRC --yes"})
  void changesNothingWhereOnlyReadingIsAllowed(String command) {
    run("file " + command, "--read-only")
        .fails(5)
        .startsWith("jopenshowvar: did not ")
        .contains("--read-only is given");
    assertThat(server.requestCount()).isZero();
  }

  @Test
  void asksForChangesOutsideT1() {
    server.controller().setMode(OperatingMode.AUT);

    assertThat(run("file cp", "/R1/A.SRC", "/R1/C.SRC").err())
        .contains("$MODE_OP is #AUT, which needs --yes");
    assertThat(run("file rm", "/R1/A.SRC").err())
        .contains("deleting cannot be undone; $MODE_OP is #AUT, which needs --yes");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "ls",
        "stat /R1/A",
        "cp /R1/A /R1/B",
        "mv /R1/A /R1/B",
        "rm /R1/A --yes",
        "get /R1/A /tmp/nowhere-jopenshowvar",
        "put pom.xml /R1/"
      })
  void saysThatKukavarproxyCannot(String command) throws IOException {
    try (MockServer old = MockServer.start()) {
      old.controller().setMode(OperatingMode.AUT);

      Cli.Result result = Cli.runOn(old, "file " + command);

      result
          .failsInLines(1)
          .last()
          .isEqualTo("KUKAVARPROXY has no files: that needs C3 Bridge Interface on the controller");
      assertThat(result.errLines().get(0))
          .startsWith("jopenshowvar: this server does not support the ")
          .endsWith("the server is KUKAVARPROXY");
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "file | missing required subcommand: ls, ",
        "file list | unknown command: 'list'",
        "file ls A B --mock | too many arguments: 'B'",
        "file stat --mock | missing required parameter: 'NAME'",
        "file rm --mock | missing required parameter: 'NAME'",
        "file cp A --mock | missing required parameter: 'TARGET'",
        "file get A --mock | needs REMOTE and LOCAL, there is only A",
        "file put A --mock | needs LOCAL and REMOTE, there is only A",
        "file ls | which controller?"
      })
  void saysWhatIsWrongWithTheUsage(String arguments, String message) {
    Cli.Result result = Cli.run(arguments.split(" "));

    assertThat(result.errLines().get(0)).startsWith("jopenshowvar: ").contains(message);
    result.failsInLines(2).last().asString().startsWith("try 'jopenshowvar file");
  }

  @Test
  void doesNotSendABlankName() {
    assertThat(run("file ls", " ").code()).isEqualTo(2);
    assertThat(run("file rm", "--yes", "/R1/A.SRC", "").code()).isEqualTo(2);
    assertThat(server.requestCount()).isZero();
  }

  @ParameterizedTest
  @ValueSource(strings = {"ls", "stat", "get", "put", "cp", "mv", "rm"})
  void explainsQuotingAndJson(String command) {
    Cli.Result result = Cli.run("file", command, "--help");

    assertThat(result.out())
        .contains("JSON: ", "a name with backslashes needs single", "Examples:");
    result.succeeds().allMatch(line -> line.length() <= 80);
  }
}
