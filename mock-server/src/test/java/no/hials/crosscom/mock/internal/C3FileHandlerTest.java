package no.hials.crosscom.mock.internal;

import static no.hials.crosscom.protocol.ErrorCode.ACCESS;
import static no.hials.crosscom.protocol.ErrorCode.ARGUMENT;
import static no.hials.crosscom.protocol.ErrorCode.GENERAL;
import static no.hials.crosscom.protocol.ErrorCode.LONG_ANSWER;
import static no.hials.crosscom.protocol.ErrorCode.MEMORY;
import static no.hials.crosscom.protocol.ErrorCode.NOT_IMPLEMENTED;
import static no.hials.crosscom.protocol.ErrorCode.PROTOCOL;
import static no.hials.crosscom.protocol.ErrorCode.SUCCESS;
import static no.hials.crosscom.protocol.ErrorCode.UNEXPECTED;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.Arrays;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MalformedRequestException;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Strictness;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TextResponse;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.EditMode;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.FileProperty;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.code.ListFlag;
import no.hials.crosscom.protocol.code.ModulePart;
import no.hials.crosscom.protocol.file.Bytes;
import no.hials.crosscom.protocol.file.FileProperties;
import no.hials.crosscom.protocol.file.FileRequest;
import no.hials.crosscom.protocol.file.FileRequest.BeginReadRequest;
import no.hials.crosscom.protocol.file.FileRequest.BeginWriteRequest;
import no.hials.crosscom.protocol.file.FileRequest.ContentRequest;
import no.hials.crosscom.protocol.file.FileRequest.CopyFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.CreateFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.DeleteFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.EndWriteRequest;
import no.hials.crosscom.protocol.file.FileRequest.FileNameRequest;
import no.hials.crosscom.protocol.file.FileRequest.FilePropertiesRequest;
import no.hials.crosscom.protocol.file.FileRequest.ListDirectoryRequest;
import no.hials.crosscom.protocol.file.FileRequest.ReadDataRequest;
import no.hials.crosscom.protocol.file.FileRequest.SetAttributesRequest;
import no.hials.crosscom.protocol.file.FileRequest.WriteDataRequest;
import no.hials.crosscom.protocol.file.FileResponse.ContentSizeResponse;
import no.hials.crosscom.protocol.file.FileResponse.FilePropertiesResponse;
import no.hials.crosscom.protocol.file.FileResponse.ListDirectoryResponse;
import no.hials.crosscom.protocol.file.FileResponse.ReadDataResponse;
import no.hials.crosscom.protocol.file.FileResponse.WriteDataResponse;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.FileTree;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

final class C3FileHandlerTest {
  private static final String PROGRAM = "KRC:\\R1\\Program\\";
  private static final long CAPACITY = 1 << 20;
  private static final Flags<CopyFlag> NONE = Flags.none(CopyFlag.class);
  private static final Flags<CopyFlag> OVERWRITE = Flags.of(CopyFlag.OVERWRITE);
  private static final Flags<CopyFlag> RECURSIVE = Flags.of(CopyFlag.RECURSIVE);
  private static final Flags<FileAttribute> READ_ONLY = Flags.of(FileAttribute.READ_ONLY);

  private static final class Watch extends Clock {
    private Instant now = Instant.parse("2026-01-02T03:04:05.123456789Z");

    @Override
    public ZoneId getZone() {
      return ZoneOffset.ofHoursMinutes(5, 30);
    }

    @Override
    public Clock withZone(ZoneId zone) {
      throw new UnsupportedOperationException();
    }

    @Override
    public Instant instant() {
      return now;
    }

    void pass(Duration time) {
      now = now.plus(time);
    }
  }

  private final Watch watch = new Watch();
  private final FileTree tree = FileTree.inMemory(watch, CAPACITY);
  private final Set<String> selected = new HashSet<>();
  private final C3FileHandler messages = new C3FileHandler(tree, selected::contains);

  private ErrorCode code(FileRequest request) {
    TypedResponse response = messages.handle(request);
    ErrorCode code = ErrorCode.from(response.tail().code()).orElseThrow();
    assertThat(response.tail().success()).isEqualTo(code == SUCCESS);
    assertThat(response.id()).isEqualTo(request.id());
    assertThat(response.type()).isEqualTo(request.type());
    return code;
  }

  private ErrorCode create(ItemType type, String name) {
    return code(
        new CreateFileRequest(1, Code.of(type), Flags.none(ModulePart.class), false, name, ""));
  }

  private ErrorCode createModule(
      boolean always, String name, String template, ModulePart... parts) {
    return code(
        new CreateFileRequest(
            1,
            Code.of(ItemType.MODULE),
            Flags.of(ModulePart.class, List.of(parts)),
            always,
            name,
            template));
  }

  private ErrorCode delete(boolean always, String name) {
    return code(new DeleteFileRequest(2, always, name));
  }

  private ErrorCode copy(Flags<CopyFlag> flags, String source, String destination) {
    return code(new CopyFileRequest(3, MessageType.COPY_FILE, flags, source, destination));
  }

  private ErrorCode move(Flags<CopyFlag> flags, String source, String destination) {
    return code(new CopyFileRequest(4, MessageType.MOVE_FILE, flags, source, destination));
  }

  private ErrorCode setReadOnly(String name) {
    return code(new SetAttributesRequest(5, READ_ONLY, READ_ONLY, name));
  }

  private FileProperties properties(String name) {
    FilePropertiesResponse response =
        (FilePropertiesResponse)
            messages.handle(new FilePropertiesRequest(6, Flags.all(FileProperty.class), name));
    assertThat(response.tail().success()).isTrue();
    return response.properties();
  }

  private ErrorCode upload(Flags<CopyFlag> flags, String name, byte[] content) {
    assertThat(code(new BeginWriteRequest(7, content.length))).isEqualTo(SUCCESS);
    for (int offset = 0; offset < content.length; offset += 64_512) {
      int count = Math.min(64_512, content.length - offset);
      WriteDataResponse written =
          (WriteDataResponse)
              messages.handle(new WriteDataRequest(8, offset, Bytes.of(content, offset, count)));
      assertThat(written.written()).isEqualTo(count);
    }
    return code(new EndWriteRequest(9, flags, name));
  }

  private ListDirectoryResponse list(Flags<ItemType> types, Flags<ListFlag> flags, String path) {
    return (ListDirectoryResponse)
        messages.handle(new ListDirectoryRequest(10, types, flags, path));
  }

  private long writeSize() {
    return ((ContentSizeResponse) messages.handle(size(MessageType.WRITE_CONTENT))).size();
  }

  private static ContentRequest size(MessageType type) {
    return new ContentRequest(11, type, Code.of(ContentOperation.SIZE));
  }

  private static ContentRequest endReading() {
    return new ContentRequest(12, MessageType.READ_CONTENT, Code.of(ContentOperation.END));
  }

  private Bytes read(long offset, long count) {
    return ((ReadDataResponse) messages.handle(new ReadDataRequest(13, offset, count))).data();
  }

  @Nested
  class Names {
    private String name(MessageType type, String path) {
      TextResponse response = (TextResponse) messages.handle(new FileNameRequest(1, type, path));
      assertThat(response.tail().success()).isEqualTo(!response.text().isEmpty());
      return response.text();
    }

    @ParameterizedTest
    @CsvSource({
      "/R1/TEST.SRC, KRC:\\R1\\PROGRAM\\TEST.SRC, /R1/TEST.SRC",
      "/r1/test.src, KRC:\\R1\\PROGRAM\\TEST.SRC, /R1/TEST.SRC",
      "/R1/Program/test.src, KRC:\\R1\\PROGRAM\\TEST.SRC, /R1/TEST.SRC",
      "krc:/r1/PROGRAM/test.src, KRC:\\R1\\PROGRAM\\TEST.SRC, /R1/TEST.SRC",
      "/R1/$CONFIG.DAT, KRC:\\R1\\SYSTEM\\$CONFIG.DAT, /R1/$CONFIG.DAT",
      "KRC:\\R1\\MADA\\$MACHINE.DAT, KRC:\\R1\\MADA\\$MACHINE.DAT, /R1/$MACHINE.DAT",
      "/R1/deep.src, KRC:\\R1\\PROGRAM\\A\\DEEP.SRC, /R1/DEEP.SRC",
      "/R1/Program, KRC:\\R1\\PROGRAM, /R1/PROGRAM",
      "KRC:\\R1\\TP\\test.src, KRC:\\R1\\TP\\TEST.SRC, /R1/TP/TEST.SRC",
      "KRC:\\, KRC:\\, /",
      "KRC:, KRC:\\, /",
      "\\, KRC:\\, /",
    })
    void areTranslatedBothWaysWhateverTheirForm(String given, String full, String krc)
        throws IOException {
      tree.put(PROGRAM + "Test.src", "");
      tree.put(PROGRAM + "a\\deep.src", "");
      tree.put("KRC:\\R1\\TP\\test.src", "");

      assertThat(name(MessageType.FULL_NAME, given)).isEqualTo(full);
      assertThat(name(MessageType.KRC_NAME, given)).isEqualTo(krc);
    }

    @Test
    void ofWhatIsNotThereAreEmpty() {
      assertThat(name(MessageType.FULL_NAME, "/NOPE/X.SRC")).isEmpty();
      assertThat(name(MessageType.KRC_NAME, PROGRAM + "A\\B\\C")).isEmpty();
    }

    @Test
    void keepLettersThatHaveNoCapitalAsOneCharacter() throws IOException {
      tree.put(PROGRAM + "maß.src", "");

      String full = name(MessageType.FULL_NAME, "/R1/MAß.SRC");

      assertThat(full).isEqualTo("KRC:\\R1\\PROGRAM\\MAß.SRC");
      assertThat(tree.exists(full)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(
        strings = {
          "",
          "X.SRC",
          "C:\\R1\\X.SRC",
          "KRC:R1\\X.SRC",
          "KRC:\\\\R1\\X.SRC",
          "KRC:\\R1\\..\\X.SRC",
          "KRC:\\R1\\.\\X.SRC",
          "/../../etc/passwd",
          "KRC:\\R1\\Program\\..",
          "KRC:\\R1\\Program\\x.src.",
          "KRC:\\R1\\Program\\x.src ",
          "KRC:\\R1\\Program\\ x.src",
          "KRC:\\R1\\Program\\x:stream",
          "KRC:\\R1\\Program\\*.src",
          "KRC:\\R1\\Program\\x?",
          "KRC:\\R1\\Program\\<x>|\"",
          "KRC:\\R1\\Program\\NUL",
          "KRC:\\R1\\Program\\con.src",
          "KRC:\\R1\\Program\\lpt1 .txt",
          "KRC:\\R1\\Program\\x\u0000y",
          "KRC:\\R1\\Program\\x\ny",
          "KRC:\\R1\\Program\\x\u007Fy",
          "KRC:\\R1\\Program\\\uD800",
        })
    void thatAreNoneAreAnInvalidArgumentOfEveryMessage(String name) {
      assertThat(code(new FileNameRequest(1, MessageType.FULL_NAME, name))).isEqualTo(ARGUMENT);
      assertThat(list(Flags.none(ItemType.class), Flags.none(ListFlag.class), name).tail().code())
          .isEqualTo(ARGUMENT.code());
      assertThat(create(ItemType.TEXT, name)).isEqualTo(ARGUMENT);
      assertThat(create(ItemType.DIRECTORY, name)).isEqualTo(ARGUMENT);
      assertThat(delete(true, name)).isEqualTo(ARGUMENT);
      assertThat(copy(NONE, "/R1/$CONFIG.DAT", name)).isEqualTo(ARGUMENT);
      assertThat(move(NONE, "/R1/$CONFIG.DAT", name)).isEqualTo(ARGUMENT);
      assertThat(setReadOnly(name)).isEqualTo(ARGUMENT);
      assertThat(upload(OVERWRITE, name, new byte[1])).isEqualTo(ARGUMENT);
      assertThat(code(new BeginReadRequest(1, NONE, name))).isEqualTo(ARGUMENT);
    }

    @Test
    void haveAtMostAsManyCharactersAsWindowsHas() throws IOException {
      String longest = PROGRAM + "x".repeat(259 - PROGRAM.length());

      assertThat(create(ItemType.TEXT, longest)).isEqualTo(SUCCESS);
      assertThat(create(ItemType.TEXT, longest + "x")).isEqualTo(ARGUMENT);
      assertThat(create(ItemType.TEXT, "/R1/" + "x/".repeat(16_000))).isEqualTo(ARGUMENT);
    }

    @Test
    void ofANewProgramInTheShortFormAreThoseOfTheProgramFolder() {
      assertThat(upload(NONE, "/R1/NEW.SRC", new byte[0])).isEqualTo(SUCCESS);
      assertThat(upload(NONE, "/STEU/NEW.TXT", new byte[0])).isEqualTo(SUCCESS);

      assertThat(tree.exists("KRC:\\R1\\Program\\new.src")).isTrue();
      assertThat(tree.exists("KRC:\\STEU\\new.txt")).isTrue();
    }
  }

  @Nested
  class Lists {
    private List<String> names(Flags<ListFlag> flags, String path, ItemType... types) {
      ListDirectoryResponse response = list(Flags.of(ItemType.class, List.of(types)), flags, path);
      assertThat(response.tail().success()).isTrue();
      return response.items();
    }

    @Test
    void areSortedWhateverTheCaseAndHaveNoInfosIfNotLong() throws IOException {
      tree.put(PROGRAM + "b.txt", "");
      tree.put(PROGRAM + "A.src", "");
      tree.put(PROGRAM + "C\\d.bin", "");

      assertThat(names(Flags.none(ListFlag.class), PROGRAM)).containsExactly("A.src", "b.txt", "C");
      assertThat(list(Flags.none(ItemType.class), Flags.none(ListFlag.class), PROGRAM).infos())
          .isEmpty();
    }

    @Test
    void haveTypeAttributesAndSizeIfLong() throws IOException {
      tree.put(PROGRAM + "a.zip", new byte[3]);
      setReadOnly(PROGRAM + "a.zip");

      assertThat(list(Flags.none(ItemType.class), Flags.of(ListFlag.LONG), PROGRAM).infos())
          .containsExactly("4,33,3");
      assertThat(list(Flags.none(ItemType.class), Flags.of(ListFlag.OLD_LONG), PROGRAM).infos())
          .containsExactly("4,33,3");
    }

    @Test
    void haveOnlyTheTypesAskedForButAllFoldersAreLookedInto() throws IOException {
      tree.put(PROGRAM + "C\\d.bin", "");
      tree.put(PROGRAM + "C\\d.src", "");

      assertThat(names(Flags.of(ListFlag.RECURSIVE), PROGRAM, ItemType.BINARY))
          .containsExactly("KRC:\\R1\\Program\\C\\d.bin");
      assertThat(names(Flags.of(ListFlag.RECURSIVE), "krc:/"))
          .contains("KRC:\\R1", "KRC:\\R1\\Program\\C\\d.src", "KRC:\\STEU\\Mada");
    }

    @Test
    void ofWhatIsNoFolderAreRefused() {
      Flags<ItemType> all = Flags.none(ItemType.class);
      Flags<ListFlag> plain = Flags.none(ListFlag.class);

      assertThat(code(new ListDirectoryRequest(1, all, plain, "KRC:\\NOPE"))).isEqualTo(GENERAL);
      assertThat(code(new ListDirectoryRequest(1, all, plain, "/R1/$config.dat")))
          .isEqualTo(ARGUMENT);
    }

    @Test
    void fitIntoAnAnswerToTheLastByte() throws IOException {
      Flags<ItemType> all = Flags.none(ItemType.class);
      Flags<ListFlag> plain = Flags.none(ListFlag.class);
      // 65535 bytes minus 8 hold 655 names of 49 characters and one of 12, with 1 byte left
      for (int i = 0; i < 655; i++) {
        tree.put(String.format("/R1/TP/%049d", i), "");
      }
      tree.put("/R1/TP/" + "x".repeat(12), "");
      ListDirectoryRequest request = new ListDirectoryRequest(1, all, plain, "/R1/TP");

      assertThat(Codec.encode(messages.handle(request))).hasSize(4 + 65_535 - 1);

      tree.delete("/R1/TP/" + "x".repeat(12));
      tree.put("/R1/TP/" + "x".repeat(13), "");
      assertThat(code(request)).isEqualTo(LONG_ANSWER);
    }
  }

  @Nested
  class Properties {
    @Test
    void haveTheTimesOfTheClockAndItsZone() throws IOException {
      tree.put(PROGRAM + "x.src", "abc");
      watch.pass(Duration.ofMinutes(1));
      tree.get(PROGRAM + "x.src");
      watch.pass(Duration.ofMinutes(1));
      tree.put(PROGRAM + "x.src", "abcd");

      FileProperties found = properties("/R1/X.SRC");

      assertThat(found.created().instant()).isEqualTo("2026-01-02T03:04:05.123456Z");
      assertThat(found.accessed().instant()).isEqualTo("2026-01-02T03:05:05.123456Z");
      assertThat(found.modified().instant()).isEqualTo("2026-01-02T03:06:05.123456Z");
      assertThat(found.created().biasMinutes()).isEqualTo(-330);
      assertThat(found.size()).isEqualTo(4);
      assertThat(found.name()).isEqualTo("x.src");
      assertThat(found.itemType().is(ItemType.MODULE)).isTrue();
      assertThat(found.editMode().is(EditMode.FULL)).isTrue();
    }

    @Test
    void changeOnlyInTheAttributesOfTheMaskThatCanBeSet() throws IOException {
      tree.put(PROGRAM + "x", "");
      Flags<FileAttribute> all = Flags.all(FileAttribute.class);

      assertThat(code(new SetAttributesRequest(1, all, all, PROGRAM + "x"))).isEqualTo(SUCCESS);
      assertThat(properties(PROGRAM + "x").attributes().bits()).isEqualTo(1 + 2 + 4 + 32);
      assertThat(properties(PROGRAM + "x").editMode().is(EditMode.READ_ONLY)).isTrue();

      Flags<FileAttribute> none = Flags.none(FileAttribute.class);
      code(new SetAttributesRequest(1, none, Flags.of(FileAttribute.HIDDEN), PROGRAM + "x"));
      assertThat(properties(PROGRAM + "x").attributes().bits()).isEqualTo(1 + 4 + 32);
    }
  }

  @Nested
  class Creating {
    @Test
    void aNewModuleContainsAProgramThatCanBeParsed() throws Exception {
      assertThat(createModule(false, "/R1/JOB", "", ModulePart.SRC, ModulePart.DAT))
          .isEqualTo(SUCCESS);

      assertThat(tree.list(PROGRAM)).containsExactly("JOB.dat", "JOB.src");
      try (MockServer server = MockServer.start()) {
        Controller controller = server.controller();
        controller.connect(tree);
        controller.robot().select(controller.loadFromFiles("/R1/JOB.SRC"));
      }
    }

    @Test
    void aModuleByTheEndOfItsNameNeedsNoParts() throws IOException {
      assertThat(createModule(false, PROGRAM + "sps.sub", "")).isEqualTo(SUCCESS);
      assertThat(createModule(false, PROGRAM + "job", "")).isEqualTo(ARGUMENT);

      assertThat(tree.list(PROGRAM)).containsExactly("sps.sub");
    }

    @Test
    void aModuleCopiesThePartsOfItsTemplate() throws IOException {
      tree.put(PROGRAM + "t.src", "source");
      tree.put(PROGRAM + "t.dat", "list");

      assertThat(createModule(false, PROGRAM + "a", PROGRAM + "t", ModulePart.SRC, ModulePart.DAT))
          .isEqualTo(SUCCESS);
      assertThat(createModule(false, PROGRAM + "b", PROGRAM + "t.src", ModulePart.SUB))
          .isEqualTo(GENERAL);

      assertThat(tree.text(PROGRAM + "a.dat")).contains("list");
      assertThat(tree.text(PROGRAM + "a.src")).contains("source");
    }

    @Test
    void aModuleOfWhichAPartIsThereChangesNothing() throws IOException {
      tree.put(PROGRAM + "job.src", "mine");

      assertThat(createModule(false, PROGRAM + "job", "", ModulePart.SRC, ModulePart.DAT))
          .isEqualTo(ACCESS);
      assertThat(tree.list(PROGRAM)).containsExactly("job.src");

      selected.add("JOB");
      assertThat(createModule(true, PROGRAM + "job", "", ModulePart.SRC, ModulePart.DAT))
          .isEqualTo(ACCESS);
      assertThat(tree.text(PROGRAM + "job.src")).contains("mine");

      selected.clear();
      assertThat(createModule(true, PROGRAM + "job", "", ModulePart.SRC, ModulePart.DAT))
          .isEqualTo(SUCCESS);
      assertThat(tree.list(PROGRAM)).containsExactly("job.dat", "job.src");
      assertThat(tree.text(PROGRAM + "job.src").orElseThrow()).contains("DEF job( )");
    }

    @Test
    void aFolderAgainNeedsAlways() {
      Code<ItemType> folder = Code.of(ItemType.DIRECTORY);
      Flags<ModulePart> none = Flags.none(ModulePart.class);

      assertThat(create(ItemType.DIRECTORY, PROGRAM + "Sub")).isEqualTo(SUCCESS);
      assertThat(create(ItemType.DIRECTORY, PROGRAM + "SUB")).isEqualTo(ACCESS);
      assertThat(code(new CreateFileRequest(1, folder, none, true, PROGRAM + "sub", "")))
          .isEqualTo(SUCCESS);
      assertThat(code(new CreateFileRequest(1, folder, none, true, "/R1/$config.dat", "")))
          .isEqualTo(ACCESS);
    }

    @Test
    void inWhatIsNoFolderIsRefused() {
      assertThat(create(ItemType.TEXT, "KRC:\\R1\\System\\$config.dat\\x")).isEqualTo(GENERAL);
      assertThat(create(ItemType.DIRECTORY, "KRC:\\R1\\System\\$config.dat\\x")).isEqualTo(GENERAL);
      assertThat(create(ItemType.TEXT, "KRC:\\R1\\Nope\\x")).isEqualTo(GENERAL);
      assertThat(create(ItemType.TEXT, "KRC:\\R1\\Program")).isEqualTo(ACCESS);
      assertThat(create(ItemType.TEXT, "KRC:\\")).isEqualTo(GENERAL);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 2, 3, 4, 128, 256, 65_535})
    void isRefusedForOtherTypes(int type) {
      assertThat(
              code(
                  new CreateFileRequest(
                      1,
                      new Code<>(ItemType.class, type),
                      Flags.none(ModulePart.class),
                      false,
                      PROGRAM + "x",
                      "")))
          .isEqualTo(ARGUMENT);
    }
  }

  @Nested
  class Deleting {
    @Test
    void takesWhatIsReadOnlyOrFullOnlyAlways() throws IOException {
      tree.put(PROGRAM + "Sub\\x.txt", "");
      setReadOnly(PROGRAM + "Sub\\x.txt");

      assertThat(delete(false, PROGRAM + "Sub\\x.txt")).isEqualTo(ACCESS);
      assertThat(delete(false, PROGRAM + "Sub")).isEqualTo(ACCESS);
      assertThat(delete(true, PROGRAM + "Sub")).isEqualTo(SUCCESS);
      assertThat(delete(true, PROGRAM + "Sub")).isEqualTo(GENERAL);
    }

    @Test
    void takesAnEmptyFolder() {
      create(ItemType.DIRECTORY, PROGRAM + "Sub");

      assertThat(delete(false, PROGRAM + "SUB\\")).isEqualTo(SUCCESS);
    }

    @ParameterizedTest
    @ValueSource(strings = {"KRC:\\", "KRC:\\R1", "/STEU"})
    void leavesTheFoldersOfTheController(String name) {
      assertThat(delete(true, name)).isEqualTo(ACCESS);
      assertThat(move(NONE, name, PROGRAM + "x")).isEqualTo(ACCESS);
    }
  }

  @Nested
  class CopyingAndMoving {
    @Test
    void overAFileNeedsAFlagAndOverAReadOnlyOneTwo() throws IOException {
      tree.put(PROGRAM + "a.txt", "new");
      tree.put(PROGRAM + "b.txt", "old");
      setReadOnly(PROGRAM + "b.txt");
      Flags<CopyFlag> both = Flags.of(CopyFlag.OVERWRITE, CopyFlag.OVERWRITE_READ_ONLY);

      assertThat(copy(NONE, PROGRAM + "a.txt", PROGRAM + "B.TXT")).isEqualTo(ACCESS);
      assertThat(copy(OVERWRITE, PROGRAM + "a.txt", PROGRAM + "B.TXT")).isEqualTo(ACCESS);
      assertThat(move(OVERWRITE, PROGRAM + "a.txt", PROGRAM + "B.TXT")).isEqualTo(ACCESS);
      assertThat(upload(OVERWRITE, PROGRAM + "b.txt", new byte[1])).isEqualTo(ACCESS);
      assertThat(copy(both, PROGRAM + "a.txt", PROGRAM + "B.TXT")).isEqualTo(SUCCESS);
      assertThat(tree.text(PROGRAM + "b.txt")).contains("new");
      assertThat(move(both, PROGRAM + "a.txt", PROGRAM + "B.TXT")).isEqualTo(SUCCESS);
      assertThat(tree.list(PROGRAM)).containsExactly("B.TXT");
    }

    @Test
    void aFolderTakesAllThatIsInIt() throws IOException {
      tree.put(PROGRAM + "A\\B\\c.txt", "c");
      tree.put(PROGRAM + "A\\d.txt", "d");

      assertThat(copy(NONE, PROGRAM + "A", PROGRAM + "E")).isEqualTo(ARGUMENT);
      assertThat(copy(RECURSIVE, PROGRAM + "A", PROGRAM + "E")).isEqualTo(SUCCESS);
      assertThat(tree.text(PROGRAM + "E\\B\\c.txt")).contains("c");
      assertThat(move(NONE, PROGRAM + "A", "KRC:\\R1\\TP\\F")).isEqualTo(SUCCESS);
      assertThat(tree.text("KRC:\\R1\\TP\\F\\d.txt")).contains("d");
      assertThat(tree.list(PROGRAM)).containsExactly("E");
    }

    @Test
    void aFolderIntoItselfOrOverSomethingIsRefused() throws IOException {
      tree.put(PROGRAM + "A\\x.txt", "");
      tree.put(PROGRAM + "y.txt", "");

      assertThat(copy(RECURSIVE, PROGRAM + "A", PROGRAM + "a\\B")).isEqualTo(ARGUMENT);
      assertThat(move(NONE, PROGRAM + "A", PROGRAM + "a\\B")).isEqualTo(ARGUMENT);
      Flags<CopyFlag> flags = Flags.of(CopyFlag.RECURSIVE, CopyFlag.OVERWRITE);
      assertThat(copy(flags, PROGRAM + "A", PROGRAM + "y.txt")).isEqualTo(ACCESS);
      assertThat(move(flags, PROGRAM + "A", PROGRAM + "y.txt")).isEqualTo(ACCESS);
      assertThat(copy(flags, PROGRAM + "y.txt", PROGRAM + "A")).isEqualTo(ACCESS);
      assertThat(copy(flags, PROGRAM + "A", "KRC:\\R1\\Nope\\A")).isEqualTo(GENERAL);
    }

    @Test
    void aFolderToWhereItsNamesGetTooLongIsRefused() throws IOException {
      tree.put(PROGRAM + "A\\" + "x".repeat(200), "");
      String deep = PROGRAM + "d".repeat(50);

      assertThat(copy(RECURSIVE, PROGRAM + "A", deep)).isEqualTo(ARGUMENT);
      assertThat(move(NONE, PROGRAM + "A", deep)).isEqualTo(ARGUMENT);
      assertThat(tree.list(PROGRAM)).containsExactly("A");
    }

    @Test
    void toTheSameNameInAnotherCaseRenames() throws IOException {
      tree.put(PROGRAM + "a.txt", "");

      assertThat(move(NONE, PROGRAM + "a.txt", PROGRAM + "A.TXT")).isEqualTo(SUCCESS);
      assertThat(tree.list(PROGRAM)).containsExactly("A.TXT");
    }

    @Test
    void isRefusedForAFileOfASelectedModule() throws IOException {
      tree.put(PROGRAM + "A\\job.dat", "");
      tree.put(PROGRAM + "x.txt", "");
      tree.put("KRC:\\STEU\\Mada\\job.dat", "");
      tree.put(PROGRAM + "job.txt", "");
      selected.add("JOB");

      assertThat(delete(true, "/R1/JOB.DAT")).isEqualTo(ACCESS);
      assertThat(delete(true, PROGRAM + "A")).isEqualTo(ACCESS);
      assertThat(move(NONE, PROGRAM + "A", PROGRAM + "B")).isEqualTo(ACCESS);
      assertThat(copy(OVERWRITE, PROGRAM + "x.txt", "/R1/JOB.DAT")).isEqualTo(ACCESS);
      assertThat(upload(OVERWRITE, "/R1/JOB.DAT", new byte[1])).isEqualTo(ACCESS);
      assertThat(delete(true, "KRC:\\STEU\\Mada\\job.dat")).isEqualTo(SUCCESS);
      assertThat(delete(true, PROGRAM + "job.txt")).isEqualTo(SUCCESS);
      selected.clear();
      assertThat(delete(true, "/R1/JOB.DAT")).isEqualTo(SUCCESS);
    }
  }

  @Nested
  class Transfers {
    @Test
    void bringAFileOfManyChunksBothWays() throws IOException {
      byte[] content = new byte[200_000];
      IntStream.range(0, content.length).forEach(i -> content[i] = (byte) (i * 31));

      assertThat(upload(NONE, PROGRAM + "big.bin", content)).isEqualTo(SUCCESS);
      assertThat(tree.get(PROGRAM + "big.bin")).isEqualTo(content);

      ContentSizeResponse begun =
          (ContentSizeResponse) messages.handle(new BeginReadRequest(1, NONE, PROGRAM + "big.bin"));
      assertThat(begun.size()).isEqualTo(200_000);
      byte[] found = new byte[content.length];
      int offset = 0;
      while (offset < found.length) {
        Bytes chunk = read(offset, ReadDataRequest.AS_MUCH_AS_FITS);
        chunk.copyTo(found, offset);
        offset += chunk.size();
        assertThat(chunk.size()).isEqualTo(offset < found.length ? 64_512 : 200_000 % 64_512);
      }
      assertThat(found).isEqualTo(content);
      assertThat(code(endReading())).isEqualTo(SUCCESS);
      assertThat(read(0, 10).size()).isZero();
    }

    @Test
    void cutDataPastTheAnnouncedSize() throws IOException {
      code(new BeginWriteRequest(1, 4));

      WriteDataResponse written =
          (WriteDataResponse)
              messages.handle(
                  new WriteDataRequest(1, 2, Bytes.of("abcd".getBytes(StandardCharsets.US_ASCII))));

      assertThat(written.written()).isEqualTo(2);
      assertThat(code(new EndWriteRequest(1, NONE, PROGRAM + "x"))).isEqualTo(SUCCESS);
      assertThat(tree.get(PROGRAM + "x")).containsExactly(0, 0, 'a', 'b');
    }

    @Test
    void fillWhatWasNeverSentWithZeros() throws IOException {
      code(new BeginWriteRequest(1, 10));
      messages.handle(new WriteDataRequest(1, 1, Bytes.of(new byte[] {1})));
      messages.handle(new WriteDataRequest(1, 4, Bytes.of(new byte[] {2})));

      code(new EndWriteRequest(1, NONE, PROGRAM + "x"));

      assertThat(tree.get(PROGRAM + "x")).containsExactly(0, 1, 0, 0, 2, 0, 0, 0, 0, 0);
    }

    @Test
    void keepTheBufferWhenTheEndFails() throws IOException {
      assertThat(upload(NONE, "/R1/$CONFIG.DAT", new byte[] {7})).isEqualTo(ACCESS);
      assertThat(writeSize()).isEqualTo(1);

      assertThat(code(new EndWriteRequest(1, NONE, PROGRAM + "other.dat"))).isEqualTo(SUCCESS);
      assertThat(tree.get(PROGRAM + "other.dat")).containsExactly(7);
      assertThat(writeSize()).isZero();
      assertThat(code(new EndWriteRequest(1, NONE, PROGRAM + "more.dat"))).isEqualTo(UNEXPECTED);
    }

    @Test
    void takeWhatIsOnItsWayFromNoFile() throws IOException {
      tree.put(PROGRAM + "x", "old");
      code(new BeginReadRequest(1, NONE, PROGRAM + "x"));
      tree.put(PROGRAM + "x", "new");

      assertThat(read(0, 3)).isEqualTo(Bytes.of("old".getBytes(StandardCharsets.US_ASCII)));
    }

    @Test
    void ofEachConnectionAreItsOwn() {
      code(new BeginWriteRequest(1, 4));
      C3FileHandler other = new C3FileHandler(tree, name -> false);

      assertThat(((ContentSizeResponse) other.handle(size(MessageType.WRITE_CONTENT))).size())
          .isZero();
      assertThat(writeSize()).isEqualTo(4);
      other.close();
    }

    @Test
    void thatFailToBeginLeaveNothingToRead() throws IOException {
      code(new BeginReadRequest(1, NONE, "/R1/$CONFIG.DAT"));

      assertThat(code(new BeginReadRequest(1, NONE, PROGRAM))).isEqualTo(ARGUMENT);
      assertThat(read(0, 10).size()).isZero();
    }

    @Test
    void endReadingAsOftenAsAsked() {
      assertThat(code(endReading())).isEqualTo(SUCCESS);
      assertThat(code(endReading())).isEqualTo(SUCCESS);
      assertThat(
              code(
                  new ContentRequest(
                      1, MessageType.READ_CONTENT, new Code<>(ContentOperation.class, 77))))
          .isEqualTo(NOT_IMPLEMENTED);
    }
  }

  @Nested
  class Limits {
    @ParameterizedTest
    @ValueSource(longs = {CAPACITY + 1, Integer.MAX_VALUE, 0xFFFF_FFFFL})
    void refuseAFileThatIsTooLargeWhenItIsAnnounced(long size) {
      assertThat(code(new BeginWriteRequest(1, size))).isEqualTo(MEMORY);
      assertThat(writeSize()).isZero();
    }

    @Test
    void takeNoMemoryForWhatIsOnlyAnnounced() {
      FileTree large = FileTree.inMemory(Clock.systemUTC(), 1L << 40);
      C3FileHandler client = new C3FileHandler(large, name -> false);

      // more than the heap of any test could hold
      for (int i = 0; i < 100; i++) {
        C3FileHandler other = new C3FileHandler(large, name -> false);
        assertThat(other.handle(new BeginWriteRequest(1, 2_000_000_000)).tail().success()).isTrue();
      }
      assertThat(client.handle(new BeginWriteRequest(1, 0xFFFF_FFFFL)).tail().code())
          .isEqualTo(MEMORY.code());
    }

    @Test
    void holdForAllConnectionsTogetherUntilOneEnds() {
      assertThat(code(new BeginWriteRequest(1, CAPACITY))).isEqualTo(SUCCESS);
      C3FileHandler other = new C3FileHandler(tree, name -> false);

      assertThat(other.handle(new BeginReadRequest(1, NONE, "/R1/$CONFIG.DAT")).tail().code())
          .isEqualTo(MEMORY.code());
      messages.close();
      assertThat(other.handle(new BeginReadRequest(1, NONE, "/R1/$CONFIG.DAT")).tail().success())
          .isTrue();
    }

    @Test
    void holdForAllFilesTogether() throws IOException {
      byte[] half = new byte[(int) CAPACITY / 2];
      assertThat(upload(NONE, PROGRAM + "a", half)).isEqualTo(SUCCESS);

      assertThat(upload(NONE, PROGRAM + "b", half)).isEqualTo(MEMORY);
      assertThat(copy(NONE, PROGRAM + "a", PROGRAM + "b")).isEqualTo(MEMORY);
      assertThat(upload(OVERWRITE, PROGRAM + "a", half)).isEqualTo(SUCCESS);
      assertThat(delete(false, PROGRAM + "a")).isEqualTo(SUCCESS);
      assertThat(upload(NONE, PROGRAM + "b", half)).isEqualTo(SUCCESS);
      create(ItemType.DIRECTORY, PROGRAM + "F");
      assertThat(move(NONE, PROGRAM + "b", PROGRAM + "F\\b")).isEqualTo(SUCCESS);
      assertThat(copy(RECURSIVE, PROGRAM + "F", PROGRAM + "G")).isEqualTo(MEMORY);
      assertThat(tree.exists(PROGRAM + "G")).isFalse();
    }

    @Test
    void countEmptyFilesAndFolders() {
      int made = 0;
      while (made <= CAPACITY / 512
          && create(ItemType.DIRECTORY, PROGRAM + "f" + made) == SUCCESS) {
        made++;
      }

      assertThat(made).isBetween(500, (int) CAPACITY / 512);
      assertThat(create(ItemType.DIRECTORY, PROGRAM + "more")).isEqualTo(MEMORY);
      assertThat(create(ItemType.TEXT, PROGRAM + "more")).isEqualTo(MEMORY);
      assertThat(createModule(false, PROGRAM + "more", "", ModulePart.SRC)).isEqualTo(MEMORY);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "14, 140009 00",
    "15, 15000000000009 00",
    "16, 160009 00",
    "17, 170009 00",
    "18, 180009 00",
    "19, 190009 00",
    "1B, 1B00000009 00",
    "1C, 1C00000009 00",
    "1D, 1D000900",
    "1D01, 1D0100000000000900",
    "1D02, 1D000900",
    "1D04, 1D04000900",
    "1E, 1E000900",
    "1E01, 1E0100000000000900",
    "1E02, 1E000900",
  })
  void aRequestThatEndsTooEarlyIsAProtocolError(String request, String answer) {
    byte[] bytes = HexFormat.of().parseHex(request);
    byte[] frame = new byte[4 + bytes.length];
    System.arraycopy(bytes, 0, frame, 4, bytes.length);
    frame[3] = (byte) bytes.length;

    byte[] answered = Codec.encode(messages.malformed(malformed(frame)));

    assertThat(HexFormat.of().withUpperCase().formatHex(answered, 4, answered.length))
        .isEqualTo(answer.replace(" ", ""));
  }

  @Test
  void propertiesThatEndTooEarlyAreAllZero() {
    byte[] frame = {0, 9, 0, 1, 26};

    assertThat(messages.malformed(malformed(frame)))
        .isEqualTo(
            new FilePropertiesResponse(9, FileProperties.NONE, new Tail(PROTOCOL.code(), 0)));
  }

  private static MalformedRequestException malformed(byte[] frame) {
    return catchThrowableOfType(
        MalformedRequestException.class,
        () ->
            Codec.decodeRequest(
                Arrays.copyOf(frame, frame.length), ServerType.C3_BRIDGE, Strictness.LENIENT));
  }
}
