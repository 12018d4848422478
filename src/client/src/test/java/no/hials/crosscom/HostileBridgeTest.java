package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.function.IntPredicate;
import java.util.stream.Stream;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLString;
import no.hials.crosscom.KRL.structs.KRLPos;
import no.hials.crosscom.c3.KeyAction;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.c3.Verification;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.E6Pos;
import no.hials.crosscom.protocol.value.Frame;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Changes the answers of C3 Bridge at random, in ways that keep the frame whole and in ways that do
 * not: whatever comes, it is a right result or an exception of the client's own, no command is sent
 * twice, and the client goes on.
 */
class HostileBridgeTest {
  private static final int SEEDS = 40;
  private static final int HEADER = 5;
  private static final byte[] CONTENT = new byte[70_000];

  private static final TransferConfig COMPARED =
      TransferConfig.create(cfg -> cfg.overwrite(true).verification(Verification.CONTENT));

  @KukaController(server = ServerType.C3_BRIDGE)
  private static MockServer robot;

  @TempDir static Path folder;

  private Between between;
  private CrossComClient client;

  @BeforeAll
  static void start() throws Exception {
    new Random(1).nextBytes(CONTENT);
    robot.controller().load("WORK.SRC", "DEF WORK()\nEND\n");
    robot.controller().setMode(OperatingMode.AUT);
    robot.variables().set("MYSTRING[]", "\"ready?\"");
  }

  @BeforeEach
  void connect() throws Exception {
    robot.files().put("/R1/THERE.TXT", CONTENT);
    between = new Between(robot);
    client =
        new CrossComClient(
            ClientConfig.create(
                between.host(),
                cfg ->
                    cfg.port(between.port())
                        .requestTimeout(Duration.ofSeconds(60))
                        .keepAlive(Duration.ZERO)));
  }

  @AfterEach
  void disconnect() throws Exception {
    client.close();
    between.close();
  }

  /** The work of a client; its checks of the result throw {@link AssertionError}. */
  @FunctionalInterface
  private interface Work {
    void on(CrossComClient client) throws Exception;
  }

  /**
   * An operation of the client.
   *
   * @param type the message whose answer is changed
   * @param mayComeTwice whether the operation sends it twice, or again if the connection is lost
   */
  private record Operation(String name, MessageType type, boolean mayComeTwice, Work work) {
    @Override
    public String toString() {
      return name;
    }
  }

  private static Operation reads(String name, MessageType type, Work work) {
    return new Operation(name, type, true, work);
  }

  private static Operation changes(String name, MessageType type, Work work) {
    return new Operation(name, type, false, work);
  }

  static Stream<Operation> operations() {
    return Stream.of(ofVariables(), ofControl(), ofFiles(), ofTransfers()).flatMap(s -> s);
  }

  private static Stream<Operation> ofVariables() {
    return Stream.of(
        reads("type", MessageType.READ, CrossComClient::getServer),
        reads("features", MessageType.FEATURES, CrossComClient::getServer),
        reads("read", MessageType.READ, c -> c.readVariable(new KRLInt("MYINT"))),
        reads("read text", MessageType.READ_UTF16, c -> c.readText("MYSTRING[]")),
        reads("read Ω", MessageType.READ_UTF16, c -> c.readText("Ω")),
        changes("write €", MessageType.WRITE_UTF16, c -> c.writeText("MYSTRING[]", "\"€?\"")),
        reads("read several", MessageType.READ_MULTIPLE, HostileBridgeTest::readSeveral),
        reads("read a value", MessageType.READ, c -> c.read("$POS_ACT", E6Pos.class)),
        changes("write a value", MessageType.WRITE, c -> c.write("$BASE", Frame.IDENTITY)),
        reads("read handles", MessageType.READ_MULTIPLE, HostileBridgeTest::readHandles),
        changes("write several", MessageType.WRITE_MULTIPLE, HostileBridgeTest::writeSeveral));
  }

  private static void readSeveral(CrossComClient client) throws CrossComException {
    List<VariableResult> results =
        client.readVariables(new KRLInt("MYINTS[1]"), new KRLString("MYSTRING[]"));
    assertThat(results).hasSize(2).allMatch(r -> !r.isOk() || r.variable().getValue() != null);
    for (VariableResult result : results) {
      result.orThrow();
    }
  }

  private static void readHandles(CrossComClient client) throws CrossComException {
    Handle.OfInt number = client.intHandle("MYINTS[1]");
    Handle<String> text = client.handle("MYSTRING[]", String.class);
    ReadResults results = client.read(number, text);
    assertThat(results.get(number)).isNotNull();
    assertThat(results.get(text)).isNotNull();
  }

  private static void writeSeveral(CrossComClient client) throws CrossComException {
    List<KRLInt> variables = new ArrayList<>();
    for (int i = 2; i <= 4; i++) {
      KRLInt variable = new KRLInt("MYINTS[" + i + "]");
      variable.setValue(i);
      variables.add(variable);
    }
    List<VariableResult> results = client.writeVariables(variables);
    assertThat(results).hasSize(3);
    for (VariableResult result : results) {
      result.orThrow();
    }
  }

  private static Stream<Operation> ofControl() {
    KRLPos up = new KRLPos("UP");
    up.setZ(1);
    return Stream.of(
        changes("select", MessageType.PROGRAM_CONTROL, c -> c.programs().select("/R1/WORK")),
        changes("stop", MessageType.PROGRAM_CONTROL, c -> c.programs().stop(Interpreter.SUBMIT)),
        changes("motion", MessageType.MOTION, c -> c.motion().linRel(up)),
        changes(
            "key",
            MessageType.PENDANT_KEY,
            c -> c.pendant().press(KeyAction.stop(Interpreter.ROBOT))),
        reads("information", MessageType.INFORMATION, c -> c.information().get()),
        changes(
            "benchmark",
            MessageType.BENCHMARK,
            c -> c.information().benchmarkWrite(1, Map.of("MYREAL", "1"))),
        changes("confirm", MessageType.CONFIRM_ALL, c -> c.information().confirmAll()));
  }

  private static Stream<Operation> ofFiles() {
    return Stream.of(
        reads("list", MessageType.LIST_DIRECTORY, c -> c.files().list("KRC:\\R1")),
        reads("exists", MessageType.FILE_PROPERTIES, c -> c.files().exists("/R1/THERE.TXT")),
        reads(
            "properties",
            MessageType.FILE_PROPERTIES,
            c -> c.files().getProperties("/R1/THERE.TXT")),
        reads("full name", MessageType.FULL_NAME, c -> c.files().getFullName("/R1/THERE.TXT")),
        changes("create", MessageType.CREATE_FILE, c -> c.files().createFile("/R1/NEW.TXT")),
        changes("delete", MessageType.DELETE_FILE, c -> c.files().delete("/R1/NEW.TXT")),
        changes("copy", MessageType.COPY_FILE, c -> c.files().copy("/R1/X.TXT", "/R1/Y.TXT")),
        changes("move", MessageType.MOVE_FILE, c -> c.files().move("/R1/X.TXT", "/R1/Y.TXT")),
        changes(
            "attributes",
            MessageType.SET_ATTRIBUTES,
            c ->
                c.files().setAttributes("/R1/THERE.TXT", Set.of(FileAttribute.ARCHIVE), Set.of())));
  }

  private static Stream<Operation> ofTransfers() {
    return Stream.of(
        reads("upload", MessageType.WRITE_CONTENT, HostileBridgeTest::upload),
        reads("download", MessageType.READ_CONTENT, HostileBridgeTest::download),
        reads("download to a file", MessageType.READ_CONTENT, HostileBridgeTest::downloadFile));
  }

  private static void upload(CrossComClient client) throws IOException {
    robot.files().put("/R1/UP.TXT", "old");
    try {
      client.files().upload(CONTENT, "/R1/UP.TXT", COMPARED);
    } catch (CrossComException e) {
      assertThat(robot.files().get("/R1/UP.TXT"))
          .as("whole or as it was")
          .satisfiesAnyOf(
              found -> assertThat(found).isEqualTo(CONTENT),
              found -> assertThat(found).isEqualTo("old".getBytes(StandardCharsets.US_ASCII)));
      throw e;
    }
    assertThat(robot.files().get("/R1/UP.TXT")).isEqualTo(CONTENT);
  }

  private static void download(CrossComClient client) throws IOException {
    assertThat(client.files().download("/R1/THERE.TXT", COMPARED)).isEqualTo(CONTENT);
  }

  private static void downloadFile(CrossComClient client) throws IOException {
    Path target = folder.resolve("there.txt");
    try {
      client.files().download("/R1/THERE.TXT", target, COMPARED);
      assertThat(Files.readAllBytes(target)).isEqualTo(CONTENT);
      Files.delete(target);
    } finally {
      assertThat(folder).isEmptyDirectory();
    }
  }

  @ParameterizedTest
  @MethodSource("operations")
  void whateverComesIsARightResultOrAnExceptionOfTheClientAndNoCommandComesTwice(
      Operation operation) throws Exception {
    int refused = 0;
    for (int seed = 0; seed < SEEDS; seed++) {
      Random random = new Random(seed);
      client.readText("MYINT");
      if (operation.type() != MessageType.READ && operation.type() != MessageType.FEATURES) {
        client.getServer();
      }
      robot.clearRequests();
      int[] answers = {random.nextInt(operation.name().contains("load") ? 6 : 1)};
      IntPredicate types = type -> type == operation.type().code() && answers[0]-- == 0;
      between.lie(types, answer -> changed(answer, random));
      refused += isRefused(operation, seed) ? 1 : 0;

      if (!operation.mayComeTwice()) {
        assertThat(requests(operation.type()))
            .as("%s, seed %s", operation, seed)
            .hasSizeLessThanOrEqualTo(1);
      }
      between.tellTheTruth();
      assertThat(client.readText("MYINT")).isEqualTo("0");
    }
    assertThat(refused).as("some answers must have been wrong").isPositive();
  }

  private List<Request> requests(MessageType type) {
    return robot.requests().stream()
        .filter(r -> r.request() != null && r.request().type() == type)
        .map(r -> r.request())
        .toList();
  }

  private boolean isRefused(Operation operation, int seed) {
    try {
      operation.work().on(client);
      return false;
    } catch (CrossComException e) {
      return true;
    } catch (IllegalArgumentException e) {
      // another type than C3 Bridge was read, and KUKAVARPROXY refuses the program's name
      assertThat(e.getCause()).isInstanceOf(CrossComUnsupportedException.class);
      return true;
    } catch (Exception e) {
      return fail(operation + ", seed " + seed + ": " + e, e);
    }
  }

  /** Makes another answer of one. */
  private static byte[] changed(byte[] answer, Random random) {
    return switch (random.nextInt(8)) {
      case 0 -> withByte(answer, random.nextInt(answer.length), random);
      case 1 -> withByte(answer, HEADER + random.nextInt(answer.length - HEADER), random);
      case 2 -> withByte(answer, Math.min(HEADER, answer.length - 1), random); // a count
      case 3 -> withLength(Arrays.copyOf(answer, HEADER + random.nextInt(answer.length - HEADER)));
      case 4 -> withLength(Arrays.copyOf(answer, answer.length + 1 + random.nextInt(9)));
      case 5 -> Arrays.copyOf(answer, random.nextInt(answer.length)); // cut
      case 6 -> Arrays.copyOf(answer, answer.length + 1 + random.nextInt(9)); // bytes after it
      default -> withCode(answer, random);
    };
  }

  private static byte[] withByte(byte[] answer, int index, Random random) {
    byte[] other = answer.clone();
    other[index] ^= (byte) (1 << random.nextInt(8));
    return other;
  }

  /** Sets the length to what there is, so that the frame is whole. */
  private static byte[] withLength(byte[] frame) {
    byte[] other = frame.length > 65_539 ? Arrays.copyOf(frame, 65_539) : frame.clone();
    other[2] = (byte) ((other.length - 4) >> 8);
    other[3] = (byte) (other.length - 4);
    return other;
  }

  /** Sets a code that may be unknown, and any flag. */
  private static byte[] withCode(byte[] answer, Random random) {
    byte[] other = answer.clone();
    other[answer.length - 3] = (byte) random.nextInt(2);
    other[answer.length - 2] = (byte) random.nextInt(256);
    other[answer.length - 1] = (byte) random.nextInt(2);
    return other;
  }
}
