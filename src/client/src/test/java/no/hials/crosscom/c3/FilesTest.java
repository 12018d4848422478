package no.hials.crosscom.c3;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.nio.file.Path;
import java.time.Instant;
import java.util.EnumSet;
import java.util.List;
import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComConnectionLostException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComTransferException;
import no.hials.crosscom.CrossComUnsupportedException;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.PlainResponse;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.Version;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.EditMode;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.code.ListFlag;
import no.hials.crosscom.protocol.code.ModulePart;
import no.hials.crosscom.protocol.file.FileProperties;
import no.hials.crosscom.protocol.file.FileRequest.ListDirectoryRequest;
import no.hials.crosscom.protocol.file.FileResponse.FilePropertiesResponse;
import no.hials.crosscom.protocol.file.FileResponse.ListDirectoryResponse;
import no.hials.crosscom.protocol.file.ItemTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Works with the file tree of a simulated controller. */
class FilesTest extends FilesRobotTest {
  private static final String PROGRAM = "KRC:\\R1\\Program";
  private static final String OTHER = PROGRAM + "\\other.src";

  @Test
  void aDirectoryIsListedWithTypesAndSizes() throws Exception {
    tree.put(PROGRAM + "\\a.txt", "12345");
    files.createDirectory(PROGRAM + "\\sub");

    List<FileEntry> entries = files.list(PROGRAM);

    assertThat(entries)
        .filteredOn(e -> e.name().equalsIgnoreCase("a.txt"))
        .singleElement()
        .satisfies(
            e -> {
              assertThat(e.size()).isEqualTo(OptionalLong.of(5));
              assertThat(e.type()).contains(Code.of(ItemType.TEXT));
              assertThat(e.isDirectory()).isFalse();
            });
    assertThat(entries)
        .filteredOn(e -> e.name().equalsIgnoreCase("sub"))
        .singleElement()
        .satisfies(
            e -> {
              assertThat(e.type()).contains(Code.of(ItemType.DIRECTORY));
              assertThat(e.attributes().orElseThrow().has(FileAttribute.DIRECTORY)).isTrue();
              assertThat(e.isDirectory()).isTrue();
            });
  }

  @Test
  void typesAndFlagsChooseWhatIsListed() throws Exception {
    tree.put(PROGRAM + "\\a.txt", "12345");
    files.createDirectory(PROGRAM + "\\sub");

    assertThat(files.list(PROGRAM, Set.of(ItemType.DIRECTORY), Set.of()))
        .extracting(e -> e.name().toLowerCase(java.util.Locale.ROOT), FileEntry::info)
        .containsExactly(org.assertj.core.groups.Tuple.tuple("sub", ""));
  }

  @Test
  void aListThatDoesNotFitIntoAnAnswerIsRefused() throws Exception {
    for (int i = 0; i < 700; i++) {
      tree.put(PROGRAM + "\\" + "x".repeat(60) + i + ".txt", "");
    }

    assertThatExceptionOfType(CrossComRefusedException.class)
        .isThrownBy(() -> files.list(PROGRAM))
        .withMessageContaining("listing of " + PROGRAM)
        .satisfies(e -> assertThat(e.getErrorCode()).contains(ErrorCode.LONG_ANSWER));
  }

  private void answerList(List<String> names, List<String> infos) {
    robot.faults(
        r ->
            r.request() instanceof ListDirectoryRequest list
                ? java.util.Optional.of(
                    Fault.raw(
                        java.util.HexFormat.of()
                            .formatHex(
                                Codec.encode(
                                    new ListDirectoryResponse(
                                        list.id(), names, infos, Tail.SUCCESS)))))
                : java.util.Optional.empty());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "text", "1,2", "1,2,3,4", "-1,2,3", "1,2,-3", "9999999999,0,0", "1, 2, 3"})
  void anInfoOfAnotherFormIsLeftAsItIs(String info) throws Exception {
    answerList(List.of("a"), List.of(info));

    assertThat(files.list(PROGRAM))
        .singleElement()
        .satisfies(
            e -> {
              assertThat(e.info()).isEqualTo(info);
              assertThat(e.type()).isEmpty();
              assertThat(e.attributes()).isEmpty();
              assertThat(e.size()).isEmpty();
            });
  }

  @Test
  void anUnknownTypeAndAttributeAreKept() throws Exception {
    answerList(List.of("a"), List.of("99,8,3"));

    FileEntry entry = files.list(PROGRAM).get(0);

    assertThat(entry.type().orElseThrow().number()).isEqualTo(99);
    assertThat(entry.attributes().orElseThrow().unknown()).isEqualTo(8);
  }

  @Test
  void infosThatAreNotAsManyAsTheItemsAreReported() {
    answerList(List.of("a", "b"), List.of("1,2,3"));

    assertThatExceptionOfType(CrossComTransferException.class)
        .isThrownBy(() -> files.list(PROGRAM))
        .withMessageContaining("there must be as many infos as items, there are 1 and 2");
  }

  @Test
  void filesAndDirectoriesExistOrNot() throws Exception {
    tree.put(FILE, "");

    assertThat(files.exists(FILE)).isTrue();
    assertThat(files.exists(PROGRAM)).isTrue();
    assertThat(files.exists(OTHER)).isFalse();
  }

  @Test
  void propertiesHaveSizeTypeAndTimes() throws Exception {
    Instant before = Instant.now().minusSeconds(5);
    tree.put(FILE, "12345");

    FileInfo info = files.getProperties(FILE);

    assertThat(info.name()).isEqualToIgnoringCase("test.src");
    assertThat(info.size()).isEqualTo(5);
    assertThat(info.isDirectory()).isFalse();
    assertThat(info.modified().orElseThrow()).isBetween(before, Instant.now().plusSeconds(5));
    assertThat(files.getProperties(PROGRAM).isDirectory()).isTrue();
  }

  @Test
  void propertiesAreThoseOfTheMessage() throws Exception {
    Instant time = Instant.parse("2022-03-24T12:00:00.1234567Z");
    FileProperties sent =
        new FileProperties(
            new Code<>(ItemType.class, 77),
            1L << 33,
            Flags.of(FileAttribute.READ_ONLY, FileAttribute.SIGNED),
            new ItemTime(time, -60),
            ItemTime.NONE,
            ItemTime.NONE,
            Code.of(EditMode.PRO_KOR),
            "x");
    lie(Step.EXISTS, id -> new FilePropertiesResponse(id, sent, Tail.SUCCESS));

    FileInfo info = files.getProperties(FILE);

    assertThat(info.type().number()).isEqualTo(77);
    assertThat(info.size()).isEqualTo(1L << 33);
    assertThat(info.attributes().known())
        .isEqualTo(EnumSet.of(FileAttribute.READ_ONLY, FileAttribute.SIGNED));
    assertThat(info.created()).contains(time);
    assertThat(info.accessed()).isEmpty();
    assertThat(info.modified()).isEmpty();
    assertThat(info.editMode()).isEqualTo(Code.of(EditMode.PRO_KOR));
  }

  @Test
  void namesAreTranslated() throws Exception {
    tree.put(FILE, "");

    assertThat(files.getFullName("/R1/test.src")).isEqualToIgnoringCase(FILE);
    assertThat(files.getKrcName(FILE)).isEqualToIgnoringCase("/R1/test.src");
  }

  @Test
  void filesModulesAndDirectoriesAreCreated() throws Exception {
    files.createFile(PROGRAM + "\\a.txt");
    files.createDirectory(PROGRAM + "\\sub");
    files.createModule(PROGRAM + "\\job");

    assertThat(tree.get(PROGRAM + "\\a.txt")).isEmpty();
    assertThat(tree.list(PROGRAM + "\\sub")).isEmpty();
    assertThat(tree.exists(PROGRAM + "\\job.src")).isTrue();
    assertThat(tree.exists(PROGRAM + "\\job.dat")).isTrue();
  }

  @Test
  void aFileIsCreatedFromATemplate() throws Exception {
    tree.put(PROGRAM + "\\template.txt", "content");

    files.create(PROGRAM + "\\a.txt", ItemType.TEXT, Set.of(), PROGRAM + "\\template.txt", false);

    assertThat(tree.text(PROGRAM + "\\a.txt")).contains("content");
  }

  @Test
  void whatIsThereIsNotCreatedUnlessAlways() throws Exception {
    tree.put(PROGRAM + "\\a.txt", "old");

    assertThatExceptionOfType(CrossComRefusedException.class)
        .isThrownBy(() -> files.createFile(PROGRAM + "\\a.txt"))
        .satisfies(e -> assertThat(e.getErrorCode()).contains(ErrorCode.ACCESS));
    assertThat(tree.text(PROGRAM + "\\a.txt")).contains("old");
    files.create(PROGRAM + "\\a.txt", ItemType.TEXT, Set.of(), null, true);
    assertThat(tree.text(PROGRAM + "\\a.txt")).contains("");
  }

  @Test
  void aReadOnlyFileIsDeletedOnlyAlways() throws Exception {
    tree.put(FILE, "");
    files.setAttributes(FILE, Set.of(FileAttribute.READ_ONLY), Set.of());

    assertThatExceptionOfType(CrossComRefusedException.class)
        .isThrownBy(() -> files.delete(FILE))
        .withMessageContaining("deletion of " + FILE);
    assertThat(tree.exists(FILE)).isTrue();
    files.delete(FILE, true);
    assertThat(tree.exists(FILE)).isFalse();
  }

  @Test
  void attributesAreSetAndCleared() throws Exception {
    tree.put(FILE, "");

    files.setAttributes(
        FILE, Set.of(FileAttribute.READ_ONLY, FileAttribute.HIDDEN), Set.of(FileAttribute.ARCHIVE));
    files.setAttributes(FILE, Set.of(), Set.of(FileAttribute.HIDDEN));

    assertThat(files.getProperties(FILE).attributes().known())
        .contains(FileAttribute.READ_ONLY)
        .doesNotContain(FileAttribute.HIDDEN, FileAttribute.ARCHIVE);
  }

  @Test
  void anAttributeCannotBeBothSetAndCleared() {
    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                files.setAttributes(
                    FILE, Set.of(FileAttribute.HIDDEN), Set.of(FileAttribute.HIDDEN)))
        .withMessage("HIDDEN cannot be both set and cleared");
    assertThat(robot.requests()).isEmpty();
  }

  @Test
  void filesAreCopiedAndMoved() throws Exception {
    tree.put(FILE, "content");

    files.copy(FILE, OTHER);
    assertThatExceptionOfType(CrossComRefusedException.class)
        .isThrownBy(() -> files.copy(FILE, OTHER))
        .withMessageContaining("copying of " + FILE + " to " + OTHER);
    files.copy(FILE, OTHER, CopyFlag.OVERWRITE);
    files.move(OTHER, PROGRAM + "\\third.src");

    assertThat(tree.text(FILE)).contains("content");
    assertThat(tree.exists(OTHER)).isFalse();
    assertThat(tree.text(PROGRAM + "\\third.src")).contains("content");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", " ", "\t"})
  void aBlankNameIsRefusedBeforeAnythingIsSent(String name) {
    assertThatIllegalArgumentException().isThrownBy(() -> files.list(name));
    assertThatIllegalArgumentException().isThrownBy(() -> files.exists(name));
    assertThatIllegalArgumentException().isThrownBy(() -> files.delete(name));
    assertThatIllegalArgumentException().isThrownBy(() -> files.copy(FILE, name));
    assertThatIllegalArgumentException().isThrownBy(() -> files.download(name));
    assertThat(robot.requests()).isEmpty();
  }

  static Stream<Arguments> changesAndCodes() {
    return Stream.of(
            MessageType.SET_ATTRIBUTES,
            MessageType.CREATE_FILE,
            MessageType.DELETE_FILE,
            MessageType.COPY_FILE,
            MessageType.MOVE_FILE)
        .flatMap(type -> IntStream.of(0, 2, 10, 99).mapToObj(code -> Arguments.of(type, code)));
  }

  private void change(ControllerFiles of, MessageType type) throws Exception {
    switch (type) {
      case SET_ATTRIBUTES -> of.setAttributes(FILE, Set.of(FileAttribute.HIDDEN), Set.of());
      case CREATE_FILE -> of.createFile(OTHER);
      case DELETE_FILE -> of.delete(FILE);
      case COPY_FILE -> of.copy(FILE, OTHER);
      case MOVE_FILE -> of.move(FILE, OTHER);
      default -> throw new AssertionError(type);
    }
  }

  @ParameterizedTest
  @MethodSource("changesAndCodes")
  void aRefusedChangeHasItsCode(MessageType type, int code) {
    robot.faults(
        r ->
            r.request() != null && r.request().type() == type
                ? java.util.Optional.of(
                    Fault.raw(
                        java.util.HexFormat.of()
                            .formatHex(
                                Codec.encode(
                                    new PlainResponse(r.request().id(), type, new Tail(code, 0))))))
                : java.util.Optional.empty());

    assertThatExceptionOfType(CrossComRefusedException.class)
        .isThrownBy(() -> change(files, type))
        .satisfies(e -> assertThat(e.getCode()).isEqualTo(code));
  }

  @ParameterizedTest
  @CsvSource({"SET_ATTRIBUTES", "CREATE_FILE", "DELETE_FILE", "COPY_FILE", "MOVE_FILE"})
  void aChangeThatIsNotAnsweredIsNotRepeatedAndItsOutcomeIsUnknown(MessageType type)
      throws Exception {
    tree.put(FILE, "");
    robot.fault(r -> r.request() != null && r.request().type() == type, Fault.closeBefore());

    assertThatExceptionOfType(CrossComConnectionLostException.class)
        .isThrownBy(() -> change(files, type))
        .satisfies(e -> assertThat(e.isOutcomeUnknown()).isTrue());
    assertThat(robot.requests())
        .filteredOn(r -> r.request() != null && r.request().type() == type)
        .hasSize(1);
  }

  @Test
  void aVersionWithoutFilesIsNamedWithTheOneThatWouldHaveThem() throws Exception {
    for (Version old : List.of(new Version(1, 0, 0), new Version(1, 1, 1))) {
      try (MockServer older =
              MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE).version(old));
          CrossComClient other = new CrossComClient(older.host(), older.port())) {
        for (Action action :
            List.<Action>of(
                () -> other.files().list(PROGRAM),
                () -> other.files().upload(bytes(9), FILE),
                () -> other.files().download(FILE))) {
          assertThatExceptionOfType(CrossComUnsupportedException.class)
              .isThrownBy(action::run)
              .withMessageContaining("it needs C3 Bridge Interface 1.1.2 or later (message ")
              .withMessageContaining("the server is C3 Bridge Interface 1.")
              .satisfies(e -> assertThat(e.getServer()).isEqualTo(ServerType.C3_BRIDGE));
        }
        assertThat(older.requests())
            .extracting(r -> r.request().type())
            .containsOnly(MessageType.READ, MessageType.FEATURES);
      }
    }
  }

  @Test
  void theFirstVersionWithFilesTransfersAndChecksThem() throws Exception {
    try (MockServer older =
            MockServer.start(
                cfg -> cfg.server(ServerType.C3_BRIDGE).version(new Version(1, 1, 2)));
        CrossComClient other = new CrossComClient(older.host(), older.port())) {
      other.files().upload(bytes(70_000), FILE);

      assertThat(other.files().download(FILE)).isEqualTo(bytes(70_000));
    }
  }

  @Test
  void onKukavarproxyNothingIsSentAndTheServerIsNamed(@TempDir Path folder) throws Exception {
    try (MockServer old = MockServer.start();
        CrossComClient client = new CrossComClient(old.host(), old.port())) {
      ControllerFiles none = client.files();
      Path target = folder.resolve("x");
      List<org.assertj.core.api.ThrowableAssert.ThrowingCallable> all =
          List.of(
              () -> none.list(PROGRAM),
              () -> none.exists(FILE),
              () -> none.getProperties(FILE),
              () -> none.getFullName(FILE),
              () -> none.getKrcName(FILE),
              () -> none.createFile(FILE),
              () -> none.delete(FILE),
              () -> none.copy(FILE, OTHER),
              () -> none.move(FILE, OTHER),
              () -> none.setAttributes(FILE, Set.of(), Set.of()),
              () -> none.upload(new byte[1], FILE),
              () ->
                  none.upload(new byte[1], FILE, TransferConfig.create(cfg -> cfg.overwrite(true))),
              () -> none.download(FILE),
              () -> none.download(FILE, target));
      for (org.assertj.core.api.ThrowableAssert.ThrowingCallable call : all) {
        assertThatExceptionOfType(CrossComUnsupportedException.class)
            .isThrownBy(call)
            .withMessageContaining("the server is KUKAVARPROXY");
      }
      assertThatExceptionOfType(CrossComUnsupportedException.class)
          .isThrownBy(() -> none.upload(new byte[1], FILE))
          .withMessageContaining("does not support the upload of " + FILE);
      assertThat(folder).isEmptyDirectory();
      assertThat(old.requests()).extracting(r -> r.request().type()).containsOnly(MessageType.READ);
    }
  }

  @Test
  void theTwinsDoTheSame() throws Exception {
    tree.put(FILE, "12345");

    assertThat(client.async(c -> c.files().exists(FILE)).get(60, TimeUnit.SECONDS)).isTrue();
    assertThat(client.async(c -> c.files().getProperties(FILE)).get(60, TimeUnit.SECONDS).size())
        .isEqualTo(5);
    assertThat(client.async(c -> c.files().list(PROGRAM)).get(60, TimeUnit.SECONDS)).isNotEmpty();
    assertThat(
            client
                .async(c -> c.files().list(PROGRAM, Set.of(), Set.of(ListFlag.LONG)))
                .get(60, TimeUnit.SECONDS))
        .isEqualTo(files.list(PROGRAM));
    assertThat(client.async(c -> c.files().getKrcName(FILE)).get(60, TimeUnit.SECONDS))
        .isEqualTo(files.getKrcName(FILE));
    assertThat(client.async(c -> c.files().getFullName("/R1/test.src")).get(60, TimeUnit.SECONDS))
        .isEqualTo(files.getFullName("/R1/test.src"));
    client.asyncRun(c -> c.files().copy(FILE, OTHER)).get(60, TimeUnit.SECONDS);
    assertThat(tree.exists(OTHER)).isTrue();
    client.asyncRun(c -> c.files().delete(OTHER)).get(60, TimeUnit.SECONDS);
    assertThat(tree.exists(OTHER)).isFalse();
    client.asyncRun(c -> c.files().move(FILE, OTHER)).get(60, TimeUnit.SECONDS);
    assertThat(tree.exists(FILE)).isFalse();
    client
        .asyncRun(c -> c.files().setAttributes(OTHER, Set.of(FileAttribute.READ_ONLY), Set.of()))
        .get(60, TimeUnit.SECONDS);
    client.asyncRun(c -> c.files().delete(OTHER, true)).get(60, TimeUnit.SECONDS);
    assertThat(tree.exists(OTHER)).isFalse();
    client.asyncRun(c -> c.files().createFile(PROGRAM + "\\a.txt")).get(60, TimeUnit.SECONDS);
    client.asyncRun(c -> c.files().createDirectory(PROGRAM + "\\sub")).get(60, TimeUnit.SECONDS);
    client.asyncRun(c -> c.files().createModule(PROGRAM + "\\job")).get(60, TimeUnit.SECONDS);
    client
        .asyncRun(
            c ->
                c.files()
                    .create(PROGRAM + "\\s", ItemType.MODULE, Set.of(ModulePart.SRC), null, false))
        .get(60, TimeUnit.SECONDS);
    assertThat(tree.list(PROGRAM))
        .map(name -> name.toLowerCase(java.util.Locale.ROOT))
        .contains("a.txt", "sub", "job.src", "job.dat", "s.src")
        .doesNotContain("s.dat");
  }
}
