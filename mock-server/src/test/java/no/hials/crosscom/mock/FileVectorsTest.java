package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import no.hials.crosscom.mock.internal.C3FileHandler;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.file.Bytes;
import no.hials.crosscom.protocol.file.FileRequest.BeginReadRequest;
import no.hials.crosscom.protocol.file.FileRequest.CopyFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.SetAttributesRequest;
import no.hials.crosscom.protocol.file.FileRequest.WriteDataRequest;
import no.hials.crosscom.protocol.file.ItemTime;
import no.hials.crosscom.simulator.FileTree;
import org.assertj.core.api.SoftAssertions;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Sends the measured requests of the types 20 to 30 (c3-vectors.tsv) in their order and on one
 * connection to a server with the same files, and expects the measured answers byte for byte.
 */
final class FileVectorsTest {
  private static final Path FILE =
      Path.of("../src/protocol/src/test/resources/no/hials/crosscom/protocol/c3-vectors.tsv");

  private static final String PROGRAM = "KRC:\\R1\\Program\\";

  private record Row(String name, String request, String answer) {}

  private MockServer server;
  private RawClient client;

  @BeforeEach
  void start() throws IOException {
    server =
        MockServer.start(
            cfg ->
                cfg.server(ServerType.C3_BRIDGE)
                    .files(tree())
                    .clock(no.hials.crosscom.simulator.SimulationClock.stepped()));
    client = new RawClient(server);
  }

  @AfterEach
  void stop() throws IOException {
    client.close();
    server.close();
  }

  /** Creates the files that the lists and properties of the measured server show. */
  private static FileTree tree() {
    Clock clock =
        Clock.fixed(ItemTime.ofTicks(0x01D8_3F12_1ADB_C000L, -60).instant(), ZoneOffset.ofHours(1));
    FileTree tree = FileTree.inMemory(clock, FileTree.DEFAULT_CAPACITY);
    try {
      tree.delete("KRC:\\R1\\TP");
      tree.put("KRC:\\R1\\Mada\\$machine.dat", new byte[32]);
      for (int i = 0; i < 1500; i++) {
        tree.put("KRC:\\R1\\Many\\one_of_too_many_files_" + i + ".txt", "");
      }
      tree.put(PROGRAM + "big.bin", new byte[200_000]);
      tree.put(PROGRAM + "Empty\\x", "");
      tree.delete(PROGRAM + "Empty\\x");
      tree.put(PROGRAM + "locked.txt", new byte[8]);
      tree.put(PROGRAM + "main.dat", new byte[21]);
      tree.put(PROGRAM + "main.src", new byte[28]);
      tree.put(PROGRAM + "notes.txt", new byte[7]);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
    Flags<FileAttribute> readOnly = Flags.of(FileAttribute.READ_ONLY);
    new C3FileHandler(tree, name -> false)
        .handle(new SetAttributesRequest(0, readOnly, readOnly, PROGRAM + "locked.txt"));
    return tree;
  }

  private static List<Row> rows() throws IOException {
    List<Row> rows = new ArrayList<>();
    for (String line : Files.readAllLines(FILE)) {
      String[] columns = line.split("\t", -1);
      if (columns[0].matches("2[0-9]|30")) {
        rows.add(new Row(columns[0] + " " + columns[1], columns[2].replace("|", ""), columns[3]));
      }
    }
    return rows;
  }

  @Test
  void thereAreRowsOfAllTypes() throws IOException {
    assertThat(rows()).hasSize(45);
    assertThat(rows().stream().map(row -> row.name().substring(0, 2)).distinct()).hasSize(11);
  }

  @Test
  void everyMeasuredRequestHasTheMeasuredAnswer() throws IOException {
    SoftAssertions soft = new SoftAssertions();
    for (Row row : rows()) {
      doWhatIsLeftOutBefore(row.name());
      client.send(HexFormat.of().parseHex(row.request()));
      soft.assertThat(HexFormat.of().formatHex(client.receiveFrame()))
          .as(row.name())
          .isEqualTo(row.answer());
    }
    soft.assertAll();
  }

  /** Needed because the file omits some of the measured rows. */
  private void doWhatIsLeftOutBefore(String row) throws IOException {
    switch (row) {
      case "25 move missing source" ->
          send(
              new CopyFileRequest(
                  1,
                  MessageType.MOVE_FILE,
                  Flags.none(CopyFlag.class),
                  PROGRAM + "Sub\\n2.txt",
                  PROGRAM + "n3.txt"));
      case "29 data offset past the end: size 0" -> {
        byte[] content = new byte[1024];
        for (int i = 0; i < content.length; i++) {
          content[i] = (byte) i;
        }
        send(new WriteDataRequest(1, 0, Bytes.of(content)));
      }
      case "30 data offset 1000 size 100: reduced to 24" ->
          send(new BeginReadRequest(1, Flags.none(CopyFlag.class), PROGRAM + "new.bin"));
      default -> {}
    }
  }

  private void send(Request request) throws IOException {
    client.send(Codec.encode(request));
    assertThat(client.receiveFrame()).as("the flag of success").endsWith((byte) 1);
  }
}
