package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Instant;
import no.hials.crosscom.mock.internal.C3FileHandler;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.FileProperty;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.code.ListFlag;
import no.hials.crosscom.protocol.code.ModulePart;
import no.hials.crosscom.protocol.file.FileProperties;
import no.hials.crosscom.protocol.file.FileRequest;
import no.hials.crosscom.protocol.file.FileRequest.BeginReadRequest;
import no.hials.crosscom.protocol.file.FileRequest.CopyFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.CreateFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.DeleteFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.FilePropertiesRequest;
import no.hials.crosscom.protocol.file.FileRequest.ListDirectoryRequest;
import no.hials.crosscom.protocol.file.FileRequest.SetAttributesRequest;
import no.hials.crosscom.protocol.file.FileResponse.FilePropertiesResponse;
import no.hials.crosscom.protocol.file.FileResponse.ListDirectoryResponse;
import no.hials.crosscom.simulator.FileTree;
import no.hials.crosscom.simulator.VariableTable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class FileTreeTest {

  @Nested
  class InMemory {
    private final FileTree tree = FileTree.inMemory();

    @Test
    void hasTheFoldersAndDataListsOfAController() throws Exception {
      assertThat(tree.list("KRC:\\")).containsExactly("R1", "STEU");
      assertThat(tree.list("KRC:\\R1")).containsExactly("Mada", "Program", "System", "TP");
      assertThat(tree.list("KRC:\\STEU")).containsExactly("Mada");
      VariableTable table = VariableTable.krc4();
      table.load("$machine.dat", tree.text("/R1/$MACHINE.DAT").orElseThrow());
      assertThat(tree.text("KRC:\\R1\\System\\$CONFIG.DAT").orElseThrow())
          .contains("DEFDAT $CONFIG");
    }

    @Test
    void keepsACopyOfTheBytesAndReturnsACopy() throws IOException {
      byte[] given = {1};
      tree.put("/R1/x.bin", given);
      given[0] = 2;
      tree.get("/R1/x.bin")[0] = 3;

      assertThat(tree.get("KRC:\\R1\\PROGRAM\\X.BIN")).containsExactly(1);
    }

    @Test
    void writesTextAsKrlIsWritten() throws IOException {
      tree.put("/R1/x.src", "Ä");

      assertThat(tree.get("/R1/x.src")).containsExactly(0xC4);
      assertThat(tree.text("/R1/x.src")).contains("Ä");
    }

    @Test
    void makesTheFoldersThatAFileNeeds() throws IOException {
      tree.put("KRC:\\R1\\program\\A\\B\\x.src", "");

      assertThat(tree.list("KRC:\\R1\\Program\\a")).containsExactly("B");
      assertThatIOException()
          .isThrownBy(() -> tree.put("KRC:\\R1\\Program\\A\\B\\x.src\\y", ""))
          .withMessage("KRC:\\R1\\Program\\A\\B\\x.src is not a folder");
      assertThatIOException()
          .isThrownBy(() -> tree.put("KRC:\\R1", ""))
          .withMessage("KRC:\\R1 is a folder");
    }

    @Test
    void saysWhatIsThere() throws IOException {
      tree.put("/R1/x.src", "");

      assertThat(tree.exists("/r1/X.SRC")).isTrue();
      assertThat(tree.exists("/R1/PROGRAM")).isTrue();
      tree.delete("/R1/X.src");
      assertThat(tree.exists("/R1/x.src")).isFalse();
      assertThat(tree.exists("")).isFalse();
      assertThat(tree.text("KRC:\\R1")).isEmpty();
      assertThatIOException()
          .isThrownBy(() -> tree.get("/R1/x.src"))
          .withMessage("KRC:\\R1\\Program\\x.src does not exist");
      assertThatIOException()
          .isThrownBy(() -> tree.list("/R1/$config.dat"))
          .withMessage("KRC:\\R1\\System\\$config.dat is not a folder");
      assertThatIOException()
          .isThrownBy(() -> tree.delete("KRC:\\R1"))
          .withMessage("KRC:\\R1 belongs to the controller");
      assertThatIOException()
          .isThrownBy(() -> tree.get("x\n.src"))
          .withMessage("a name must begin with KRC:\\ or a slash, is \"x?.src\"");
    }

    @Test
    void hasRoomForItsDataListsAtLeast() {
      assertThatIllegalArgumentException()
          .isThrownBy(() -> FileTree.inMemory(Clock.systemUTC(), (1 << 20) - 1))
          .withMessage("capacity must be 1 MiB or more, is 1048575");
    }
  }

  @Nested
  class OverAFolder {
    private static final String PROGRAM = "KRC:\\R1\\Program\\";

    @TempDir private Path folder;
    @TempDir private Path outside;
    private FileTree tree;
    private C3FileHandler messages;

    @BeforeEach
    void start() throws IOException {
      tree = FileTree.over(folder, Clock.systemUTC(), 1 << 20);
      messages = new C3FileHandler(tree, name -> false);
    }

    private Path program(String name) {
      return folder.resolve("R1").resolve("Program").resolve(name);
    }

    private ErrorCode code(FileRequest request) {
      TypedResponse response = messages.handle(request);
      return ErrorCode.from(response.tail().code()).orElseThrow();
    }

    private FileProperties properties(String name) {
      return ((FilePropertiesResponse)
              messages.handle(new FilePropertiesRequest(1, Flags.all(FileProperty.class), name)))
          .properties();
    }

    private ErrorCode move(String source, String destination) {
      return code(
          new CopyFileRequest(
              1, MessageType.MOVE_FILE, Flags.none(CopyFlag.class), source, destination));
    }

    private ErrorCode setAttributes(FileAttribute attribute, String name) {
      return code(new SetAttributesRequest(1, Flags.of(attribute), Flags.of(attribute), name));
    }

    @Test
    void makesTheFoldersOfAControllerThatAreMissing() throws IOException {
      assertThat(program("")).isDirectory();
      assertThat(FileTree.over(folder).list("KRC:\\R1"))
          .containsExactly("Mada", "Program", "System", "TP");
    }

    @Test
    void aFileIsReplacedAsAWholeSoThatAFullDiskLeavesNoHalfOne() throws IOException {
      Path old = outside.resolve("old");
      Files.writeString(program("x.src"), "there");
      Files.createLink(old, program("x.src"));

      tree.put("/R1/X.SRC", "new".getBytes(StandardCharsets.US_ASCII));

      assertThat(program("x.src")).hasContent("new");
      assertThat(old).hasContent("there");
      assertThat(program("").toFile().list()).containsExactly("x.src");
    }

    @Test
    void readsAndWritesTheFilesOfTheFolder() throws IOException {
      Files.writeString(program("x.src"), "there");

      assertThat(tree.text("/R1/X.SRC")).contains("there");
      tree.put("/R1/X.SRC", "new");
      tree.put(PROGRAM + "Sub\\y.src", "more");

      assertThat(program("x.src")).hasContent("new");
      assertThat(program("Sub").resolve("y.src")).hasContent("more");
      assertThat(tree.list(PROGRAM)).containsExactly("Sub", "x.src");
      assertThat(tree.list("KRC:\\R1\\Program\\SUB")).containsExactly("y.src");
    }

    @Test
    void showsTheTimesOfTheFiles() throws IOException {
      Files.writeString(program("x.src"), "there");
      Instant time = Instant.parse("2020-02-03T04:05:06Z");
      Files.setLastModifiedTime(program("x.src"), java.nio.file.attribute.FileTime.from(time));

      FileProperties found = properties(PROGRAM + "X.SRC");

      assertThat(found.modified().instant()).isEqualTo(time);
      assertThat(found.name()).isEqualTo("x.src");
      assertThat(found.size()).isEqualTo(5);
      assertThat(found.attributes().bits()).isEqualTo(FileAttribute.ARCHIVE.code());
    }

    @Test
    void copiesMovesCreatesAndDeletes() throws IOException {
      tree.put(PROGRAM + "A\\x.txt", "x");
      Flags<CopyFlag> recursive = Flags.of(CopyFlag.RECURSIVE);

      assertThat(
              code(
                  new CopyFileRequest(
                      1, MessageType.COPY_FILE, recursive, PROGRAM + "A", PROGRAM + "B")))
          .isEqualTo(ErrorCode.SUCCESS);
      assertThat(move(PROGRAM + "A", PROGRAM + "C")).isEqualTo(ErrorCode.SUCCESS);
      assertThat(
              code(
                  new CreateFileRequest(
                      1,
                      Code.of(ItemType.MODULE),
                      Flags.of(ModulePart.DAT),
                      false,
                      PROGRAM + "m",
                      "")))
          .isEqualTo(ErrorCode.SUCCESS);
      assertThat(code(new DeleteFileRequest(1, true, PROGRAM + "b"))).isEqualTo(ErrorCode.SUCCESS);

      assertThat(program("C").resolve("x.txt")).hasContent("x");
      assertThat(program("m.dat")).isNotEmptyFile();
      assertThat(program("A")).doesNotExist();
      assertThat(program("B")).doesNotExist();
    }

    @Test
    void keepsAttributesWithTheFileWhereverItIsMoved() throws IOException {
      tree.put(PROGRAM + "A\\x.txt", "x");
      setAttributes(FileAttribute.READ_ONLY, PROGRAM + "A\\X.TXT");

      move(PROGRAM + "a", PROGRAM + "B");

      assertThat(properties(PROGRAM + "B\\x.txt").attributes().bits()).isEqualTo(1 + 32);
      assertThat(code(new DeleteFileRequest(1, false, PROGRAM + "B\\x.txt")))
          .isEqualTo(ErrorCode.ACCESS);
      tree.delete(PROGRAM + "B\\x.txt");
      tree.put(PROGRAM + "B\\x.txt", "again");
      assertThat(properties(PROGRAM + "B\\x.txt").attributes().bits()).isEqualTo(32);
    }

    @Test
    void neverFollowsALink() throws IOException {
      Path secret = Files.writeString(outside.resolve("secret.src"), "secret");
      Files.createSymbolicLink(program("file.src"), secret);
      Files.createSymbolicLink(program("gone.src"), outside.resolve("new.src"));
      Files.createSymbolicLink(program("dir"), outside);

      for (String name : new String[] {"file.src", "GONE.SRC", "dir", "dir\\secret.src"}) {
        Flags<CopyFlag> overwrite = Flags.of(CopyFlag.OVERWRITE);
        Flags<ListFlag> none = Flags.none(ListFlag.class);
        assertThat(code(new BeginReadRequest(1, overwrite, PROGRAM + name)))
            .as(name)
            .isEqualTo(ErrorCode.ACCESS);
        assertThatIOException().isThrownBy(() -> tree.put(PROGRAM + name, "overwritten"));
        assertThatIOException().isThrownBy(() -> tree.put(PROGRAM + name + "\\x", "overwritten"));
        assertThat(code(new DeleteFileRequest(1, true, PROGRAM + name)))
            .isEqualTo(ErrorCode.ACCESS);
        assertThat(
                code(new ListDirectoryRequest(1, Flags.none(ItemType.class), none, PROGRAM + name)))
            .isEqualTo(ErrorCode.ACCESS);
        assertThat(move(PROGRAM + name, PROGRAM + "new")).isEqualTo(ErrorCode.ACCESS);
      }
      ListDirectoryResponse all =
          (ListDirectoryResponse)
              messages.handle(
                  new ListDirectoryRequest(
                      1, Flags.none(ItemType.class), Flags.of(ListFlag.RECURSIVE), "KRC:\\"));
      assertThat(all.items()).hasSize(7);
      assertThat(outside).isDirectoryNotContaining("glob:**new.src");
      assertThat(secret).hasContent("secret");
    }

    @Test
    void keepsALinkToAFileOfTheFolderAndRefusesItsName() throws IOException {
      tree.put(PROGRAM + "x.src", "kept");
      Path link = Files.createSymbolicLink(program("link.src"), Path.of("x.src"));

      for (String name : new String[] {PROGRAM + "link.src", PROGRAM + "LINK.SRC"}) {
        String refusal = name + " is a link, or not a file";
        assertThatIOException().isThrownBy(() -> tree.get(name)).withMessage(refusal);
        assertThatIOException().isThrownBy(() -> tree.put(name, "x")).withMessage(refusal);
        assertThatIOException().isThrownBy(() -> tree.delete(name)).withMessage(refusal);
        assertThat(move(PROGRAM + "x.src", name)).isEqualTo(ErrorCode.ACCESS);
      }
      assertThat(link).isSymbolicLink().hasContent("kept");
    }

    @Test
    void deletesAFolderWithALinkInItNotWhatTheLinkShows() throws IOException {
      Path kept = Files.writeString(outside.resolve("kept.txt"), "kept");
      Files.createDirectory(program("A"));
      Files.createSymbolicLink(program("A").resolve("link"), outside);

      assertThatIOException().isThrownBy(() -> tree.delete(PROGRAM + "A"));

      assertThat(kept).hasContent("kept");
    }

    @Test
    void doesNotSeeNamesThatNoControllerHas() throws IOException {
      assumeTrue(java.io.File.separatorChar == '/', "Windows refuses these names itself");
      Files.writeString(program("a:b.src"), "");
      Files.writeString(program("trailing. "), "");
      Files.writeString(program("back\\slash"), "");
      Files.writeString(program("x.SRC"), "second");
      Files.writeString(program("X.src"), "first");

      assertThat(tree.list(PROGRAM)).hasSize(1).first().asString().isEqualToIgnoringCase("x.src");
      assertThat(tree.text("/R1/x.src")).contains("first");
    }

    @Test
    void countsWhatIsInTheFolderAndReadsNoLargerFile() throws IOException {
      Files.write(program("large.bin"), new byte[(1 << 20) + 1]);

      assertThat(code(new BeginReadRequest(1, Flags.none(CopyFlag.class), PROGRAM + "large.bin")))
          .isEqualTo(ErrorCode.MEMORY);
      assertThatIOException()
          .isThrownBy(() -> tree.put("/R1/x.src", ""))
          .withMessage("KRC:\\R1\\Program\\x.src does not fit, the limit is 1048576 bytes in all");
      Files.delete(program("large.bin"));
      tree.put("/R1/x.src", "");
    }

    @Test
    void failsWithoutAReasonWhenTheFileSystemDoes() throws IOException {
      // 250 characters of three bytes are too long a name for most file systems, not for Windows
      String name = PROGRAM + "€".repeat(240);
      assumeTrue(java.io.File.separatorChar == '/', "Windows counts characters");

      assertThat(
              code(
                  new CreateFileRequest(
                      1,
                      Code.of(ItemType.DIRECTORY),
                      Flags.none(ModulePart.class),
                      false,
                      name,
                      "")))
          .isIn(ErrorCode.GENERAL, ErrorCode.ARGUMENT);
    }

    @Test
    void needsAFolder() throws IOException {
      Path file = Files.writeString(outside.resolve("file"), "");

      assertThatIOException().isThrownBy(() -> FileTree.over(outside.resolve("none")));
      assertThatIOException().isThrownBy(() -> FileTree.over(file));
    }
  }
}
