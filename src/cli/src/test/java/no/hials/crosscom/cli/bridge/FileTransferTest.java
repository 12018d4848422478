package no.hials.crosscom.cli.bridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.Progress;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.file.FileRequest.BeginReadRequest;
import no.hials.crosscom.protocol.file.FileRequest.EndWriteRequest;
import no.hials.crosscom.protocol.file.FileRequest.ReadDataRequest;
import no.hials.crosscom.protocol.file.FileRequest.WriteDataRequest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code file put} and {@code file get}. */
class FileTransferTest {
  private static final String A = "DEF A ( )\n  WAIT FOR $IN[1]\nEND\n";

  @TempDir private Path dir;

  @KukaController(server = ServerType.C3_BRIDGE)
  private MockServer server;

  private Cli.Result put(String... args) {
    return Cli.runOn(server, "file put", args);
  }

  private Cli.Result get(String... args) {
    return Cli.runOn(server, "file get", args);
  }

  private String file(String name, String content) throws IOException {
    return Files.writeString(dir.resolve(name), content, StandardCharsets.ISO_8859_1).toString();
  }

  private List<String> localFiles() throws IOException {
    try (Stream<Path> files = Files.list(dir)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }

  // put

  @ParameterizedTest
  @CsvSource({
    "KRC:\\R1\\PROGRAM,KRC:\\R1\\PROGRAM\\a.src",
    "KRC:\\R1\\PROGRAM\\,KRC:\\R1\\PROGRAM\\a.src",
    "/R1,/R1/a.src",
    "/R1/,/R1/a.src",
    "/R1/NEW.SRC,/R1/NEW.SRC",
    "KRC:\\R1\\TP\\NEW.SRC,KRC:\\R1\\TP\\NEW.SRC"
  })
  void uploadsIntoAFolderOrUnderAName(String remote, String name) throws IOException {
    String local = file("a.src", A);

    put(local, remote).succeeds().containsExactly(local + " -> " + name + ", 32 bytes");
    assertThat(server.files().text(name)).hasValue(A);
  }

  @Test
  void uploadsSeveralFilesAndPrintsJson() throws IOException {
    String a = file("a.src", A);
    String b = file("\u00e4\u4e2d b.txt", "x");

    assertThat(put(a, b, "KRC:\\R1\\TP", "--json").lines())
        .hasSize(2)
        .first()
        .asString()
        .endsWith("a.src\",\"name\":\"KRC:\\\\R1\\\\TP\\\\a.src\",\"size\":32}");
    assertThat(server.files().text("KRC:\\R1\\TP\\\u00e4\u4e2d b.txt")).hasValue("x");
    assertThat(put(b, "/R1/ONE.TXT").lines()).containsExactly(b + " -> /R1/ONE.TXT, 1 byte");
  }

  @Test
  void uploadsTheDataListBesideAProgramBeforeIt() throws IOException {
    String src = file("a.src", A);
    String dat = file("A.DAT", "DEFDAT A\nENDDAT\n");

    assertThat(put(src, "/R1/", "--with-dat").lines())
        .containsExactly(dat + " -> /R1/A.DAT, 16 bytes", src + " -> /R1/a.src, 32 bytes");
    assertThat(put(src, "--with-dat", "/R1/B.SRC").lines())
        .containsExactly(dat + " -> /R1/B.DAT, 16 bytes", src + " -> /R1/B.SRC, 32 bytes");
    assertThat(put(file("c.src", A), "/R1/", "--with-dat").lines()).hasSize(1);
  }

  @Test
  void uploadsTheDataListInTheCaseOfItsProgram() throws IOException {
    String src = file("weld.src", A);
    file("WELD.DAT", "wrong");
    file("Weld.dat", "wrong");
    assumeThat(localFiles()).as("the file system tells cases apart").hasSize(3);

    Cli.Result unclear = put(src, "/R1/", "--with-dat");
    String dat = file("weld.dat", "right");
    Cli.Result exact = put(src, "/R1/", "--with-dat");

    assertThat(unclear.errLines())
        .containsExactly(
            "jopenshowvar: " + src + " has several data lists: WELD.DAT, Weld.dat; rename one");
    assertThat(unclear.code()).isEqualTo(2);
    assertThat(exact.lines()).first().isEqualTo(dat + " -> /R1/weld.dat, 5 bytes");
    assertThat(server.files().text("/R1/weld.dat")).hasValue("right");
  }

  @Test
  void uploadsAFileOfManyParts() throws IOException {
    byte[] content = new byte[300_000];
    new Random(1).nextBytes(content);
    Path large = Files.write(dir.resolve("large.bin"), content);

    assertThat(put(large.toString(), "KRC:\\R1\\TP\\").code()).isZero();

    assertThat(server.files().get("KRC:\\R1\\TP\\large.bin")).isEqualTo(content);
  }

  @Test
  void overwritesOnlyIfToldTo() throws IOException {
    server.files().put("/R1/A.SRC", "old");
    String local = file("a.src", A);

    put(local, "/R1/")
        .failsInLines(5)
        .containsExactly(
            "jopenshowvar: did not upload "
                + local
                + ": /R1/a.src already exists, which needs --yes");
    assertThat(server.files().text("/R1/A.SRC")).hasValue("old");

    assertThat(put(local, "/R1/", "--yes").code()).isZero();
    assertThat(server.files().text("/R1/A.SRC")).hasValue(A);
  }

  @Test
  void uploadsNothingIfOneOfSeveralIsThereAlready() throws IOException {
    server.files().put("/R1/B.SRC", "old");

    assertThat(put(file("a.src", A), file("b.src", A), "/R1/").code()).isEqualTo(5);

    assertThat(server.files().exists("/R1/A.SRC")).isFalse();
  }

  @Test
  void selectsTheProgramThatItUploaded() throws IOException {
    String src = file("a.src", A);
    file("a.dat", "DEFDAT A\nENDDAT\n");

    assertThat(put(src, "KRC:\\R1\\PROGRAM\\", "--with-dat", "--select").lines())
        .hasSize(3)
        .last()
        .isEqualTo("robot: A #P_RESET");
    assertThat(server.controller().robot().program()).hasValue("A");
  }

  @Test
  void saysWhatSelectAnsweredIfTheProgramHasErrors() throws IOException {
    String src = file("bad.src", "DEF BAD ( )\n  MYINT = = 3\nEND\n");

    Cli.Result result = put(src, "/R1/", "--select");

    assertThat(result.lines()).containsExactly(src + " -> /R1/bad.src, 30 bytes");
    assertThat(result.errLines())
        .containsExactly(
            "jopenshowvar: the server refused the selection of program /R1/BAD: code 0"
                + " (GENERAL: no reason given)",
            "likely cause: the program has errors; it was uploaded, but not selected",
            src + ":2:11: expected a value, found =");
    assertThat(result.code()).isEqualTo(1);
  }

  @Test
  void saysThatTheProgramIsInUse() throws Exception {
    server.files().put("/R1/A.SRC", A);
    assertThat(Cli.runOn(server, "program select", "/R1/A").code()).isZero();

    Cli.Result result = put(file("a.src", A + ";\n"), "/R1/", "--yes");

    assertThat(result.errLines().get(0)).contains("code 2 (ACCESS");
    assertThat(result.errLines().get(1))
        .startsWith("likely cause: it is read-only, or belongs to the selected program");
    assertThat(result.code()).isEqualTo(1);
    assertThat(server.files().text("/R1/A.SRC")).hasValue(A);
  }

  @Test
  void leavesNothingOfAFileIfTheConnectionIsLostInTheMiddle() throws IOException {
    Path large = Files.write(dir.resolve("large.bin"), new byte[200_000]);
    server.fault(
        each -> each.request() instanceof WriteDataRequest data && data.offset() > 100_000,
        Fault.closeBefore());

    Cli.Result result = put(large.toString(), file("b.txt", "b"), "KRC:\\R1\\TP\\");

    result.failsInLines(4).last().isEqualTo("not uploaded: KRC:\\R1\\TP\\b.txt");
    assertThat(result.errLines().get(0))
        .startsWith("jopenshowvar: the connection to ")
        .contains("(nothing was stored)");
    assertThat(server.files().exists("KRC:\\R1\\TP\\large.bin")).isFalse();
  }

  @Test
  void neverRepeatsAnUploadWhoseEndWasNotAnswered() throws IOException {
    server.fault(each -> each.request() instanceof EndWriteRequest, Fault.closeDuring(3));

    Cli.Result result = put(file("a.src", A), "/R1/");

    assertThat(result.errLines().get(0))
        .contains("the outcome is unknown")
        .doesNotContain("nothing was stored");
    assertThat(result.code()).isEqualTo(4);
    assertThat(server.requests())
        .filteredOn(each -> each.request() instanceof EndWriteRequest)
        .hasSize(1);
  }

  @Test
  void printsThatAFileIsStoredIfItsVerificationBreaks() throws IOException {
    server.fault(each -> each.request() instanceof BeginReadRequest, Fault.closeBefore());

    Cli.Result result = put(file("a.src", A), "KRC:\\R1\\TP\\");

    assertThat(result.errLines().get(0)).contains("(the file is stored but was not verified)");
    assertThat(result.code()).isEqualTo(4);
    assertThat(server.files().exists("KRC:\\R1\\TP\\a.src")).isTrue();
  }

  @Test
  void uploadsNothingWhereOnlyReadingIsAllowed() throws IOException {
    assertThat(put(file("a.src", A), "/R1/", "--read-only", "--yes").code()).isEqualTo(5);
    assertThat(server.requestCount()).isZero();
  }

  @Test
  void asksOutsideT1() throws IOException {
    server.controller().setMode(OperatingMode.EXT);

    put(file("a.src", A), "/R1/")
        .fails(5)
        .endsWith(": $MODE_OP is #EX, which needs --yes" + System.lineSeparator());
    assertThat(server.files().exists("/R1/A.SRC")).isFalse();
  }

  @Test
  void checksTheFilesOfThisComputerBeforeItConnects() throws IOException {
    String gone = dir.resolve("gone.src").toString();

    assertThat(put(file("a.src", A), gone, "/R1/").errLines())
        .containsExactly("jopenshowvar: cannot read " + gone + ": file not found");
    assertThat(put(dir.toString(), "/R1/").errLines())
        .containsExactly("jopenshowvar: cannot read " + dir + ": it is a folder");
    assertThat(put(file("b.txt", ""), "/R1/", "--select").err())
        .contains("--select needs one .src file, there are 0");
    assertThat(server.requestCount()).isZero();
  }

  @Test
  void putsSeveralFilesIntoAFolderOnly() throws IOException {
    put(file("a.src", A), file("b.src", A), "/R1/NEW")
        .fails(2)
        .contains("for several files REMOTE must be a folder, /R1/NEW is not");
  }

  @Test
  void doesNotLetTwoFilesBecomeOne() throws IOException {
    String local = file("a.src", A);

    assertThat(put(local, local, "/R1/").err()).contains("two files would have the name /R1/a.src");
    assertThat(get("/R1/A.SRC", "KRC:\\R1\\TP\\A.SRC", dir.toString()).err())
        .contains("two files would have the name ");
  }

  // get

  @Test
  void downloadsIntoAFolderOrUnderAName() throws IOException {
    server.files().put("KRC:\\R1\\Program\\A.SRC", A);
    Path named = dir.resolve("named.src");

    assertThat(get("/R1/A.SRC", dir.toString()).lines())
        .containsExactly("/R1/A.SRC -> " + dir.resolve("A.SRC") + ", 32 bytes");
    assertThat(get("KRC:\\R1\\PROGRAM\\A.SRC", named.toString(), "--json").lines())
        .singleElement()
        .asString()
        .startsWith("{\"command\":\"get\",\"local\":\"")
        .endsWith("\"name\":\"KRC:\\\\R1\\\\PROGRAM\\\\A.SRC\",\"size\":32}");
    assertThat(named).hasContent(A);
    assertThat(localFiles()).containsExactly("A.SRC", "named.src");
  }

  @Test
  void downloadsTheDataListBesideAProgram() throws IOException {
    server.files().put("KRC:\\R1\\Program\\A.SRC", A);
    server.files().put("KRC:\\R1\\Program\\A.DAT", "DEFDAT A\nENDDAT\n");

    assertThat(get("/R1/A.SRC", dir.toString(), "--with-dat").lines()).hasSize(2);
    assertThat(localFiles()).containsExactly("A.DAT", "A.SRC");
  }

  @Test
  void overwritesAFileOfThisComputerOnlyIfToldTo() throws IOException {
    server.files().put("/R1/A.SRC", A);
    String local = file("mine.src", "mine");

    get("/R1/A.SRC", local)
        .failsInLines(5)
        .containsExactly(
            "jopenshowvar: did not overwrite it: " + local + " already exists, which needs --yes");
    assertThat(Path.of(local)).hasContent("mine");

    assertThat(get("/R1/A.SRC", local, "--yes").code()).isZero();
    assertThat(Path.of(local)).hasContent(A);
  }

  @Test
  void keepsTheOldFileIfTheConnectionIsLost() throws IOException {
    server.files().put("KRC:\\R1\\TP\\large.bin", new byte[200_000]);
    server.fault(
        each -> each.request() instanceof ReadDataRequest data && data.offset() > 100_000,
        Fault.closeBefore());
    String local = file("large.bin", "old");

    get("KRC:\\R1\\TP\\large.bin", local, "--yes").fails(4);
    assertThat(Path.of(local)).hasContent("old");
    assertThat(localFiles()).containsExactly("large.bin");
  }

  @Test
  void saysThatItIsNotThere() throws IOException {
    get("/R1/NOPE.SRC", dir.toString())
        .failsInLines(1)
        .last()
        .asString()
        .contains("file or folder not found");
    assertThat(localFiles()).isEmpty();
  }

  @Test
  void checksThePlaceBeforeItConnects() {
    get("/R1/A.SRC", dir.resolve("gone/a.src").toString())
        .fails(74)
        .isEqualTo(
            "jopenshowvar: could not write "
                + dir.resolve("gone/a.src")
                + ": there is no folder "
                + dir.resolve("gone")
                + System.lineSeparator());
    assertThat(get("/R1/A", "/R1/B", dir.resolve("x").toString()).code()).isEqualTo(2);
    assertThat(server.requestCount()).isZero();
  }

  @Test
  void takesANameThatEndsLikeAFolderForOne() throws IOException {
    get("/R1/A.SRC", dir.resolve("gone") + "/")
        .fails(74)
        .contains("there is no folder " + dir.resolve("gone"));
    get("/R1/A.SRC", dir.resolve("gone") + File.separator).fails(74);
    assertThat(localFiles()).isEmpty();
    assertThat(server.requestCount()).isZero();
  }

  @ParameterizedTest
  @ValueSource(strings = {"KRC:\\R1\\..", "/R1/.."})
  void leavesItsFolderForNoName(String name) throws IOException {
    get(name, dir.toString()).fails(2).contains("is a folder");
    assertThat(localFiles()).isEmpty();
  }

  // progress

  @Test
  void showsHowFarATransferHasCome() {
    assertThat(Progress.text("X", 0, 0)).isEqualTo("X: all of 0 KB, checking");
    assertThat(Progress.text("X", 64_512, 200_000)).isEqualTo("X: 32 % of 196 KB");
    assertThat(Progress.text("X", 200_000, 200_000)).isEqualTo("X: all of 196 KB, checking");
  }
}
