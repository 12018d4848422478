package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.MalformedFrameException;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.TextResponse;
import no.hials.crosscom.protocol.variable.AccessResult;
import no.hials.crosscom.protocol.variable.VariableResponse.MultipleResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;
import no.hials.crosscom.simulator.SimulationClock;
import no.hials.crosscom.simulator.VariableTable;
import org.junit.jupiter.api.Test;

/**
 * Sends every row of the measured requests, {@code c3-vectors.tsv}, in their order to one server,
 * and compares the answers and the state of the connection.
 */
final class C3VectorsTest {
  private static final HexFormat HEX = HexFormat.ofDelimiter(" ").withUpperCase();
  private static final int GIVE_UP_MILLIS = 20_000;

  /** The port of the measured server. */
  private static final String PORT = "7000";

  /** The rows that cannot be compared, with the reason. */
  private static final Map<String, String> LEFT_OUT =
      Map.ofEntries(
          Map.entry("0 read empty value", "no KRL value has an empty text"),
          Map.entry("4 read empty value", "no KRL value has an empty text"),
          Map.entry("0 read back MYPOS", "the stand-in prints REAL with one place"),
          Map.entry("4 read $AXIS_ACT", "the stand-in prints REAL with one place"),
          Map.entry(
              "6 read known, unknown, read-only error kinds, PING",
              "a variable of the stand-in that answers NOT_IMPLEMENTED"),
          Map.entry(
              "raw ten requests in one write, first takes 500 ms",
              "a variable of the stand-in that answers late, without quotes"),
          Map.entry(
              "11 specification sample, 3.7.1. MESSAGE #11. MOTION CONTROL (answer equals the"
                  + " printed one)",
              "the robot cannot reach its own foot"));

  /** The actions before a row, by the start of its request and its meaning. */
  private final Map<String, Step> before =
      Map.ofEntries(
          Map.entry("0131 read back $OV_PRO", s -> s.variables().set("$OV_PRO", "75")),
          Map.entry("014c read $PRO_STATE1", s -> s.controller().robot().stop()),
          Map.entry("0153 stop submit interpreter 0", C3VectorsTest::startSubmit),
          Map.entry("016a key start, interpreter 1, forward, pressed", C3VectorsTest::prepareStart),
          Map.entry("016e key stop", s -> s.controller().robot().stop()),
          Map.entry(
              "01e7 one and a half requests, then the rest", s -> s.variables().set("MYINT", "5")));

  /** An action that can fail. */
  private interface Step {
    void run(MockServer server) throws Exception;
  }

  /**
   * A row of the file.
   *
   * @param type the message type, {@code raw} or the UDP port
   * @param meaning the meaning of the row
   * @param segments the request, each sent by one write
   * @param answerHex, empty for none
   * @param fate {@code open}, {@code FIN}, or the port of a datagram's sender
   */
  record Row(String type, String meaning, List<byte[]> segments, String answerHex, String fate) {

    static Row parse(String line) {
      String[] columns = line.split("\t", -1);
      List<byte[]> segments = new ArrayList<>();
      for (String segment : columns[2].split("\\|", -1)) {
        segments.add(HexFormat.of().parseHex(segment));
      }
      String answer = columns[3].equals("-") ? "" : columns[3];
      return new Row(columns[0], columns[1], segments, answer, columns[4]);
    }

    byte[] answer() {
      return HexFormat.of().parseHex(answerHex);
    }

    String name() {
      return type + " " + meaning;
    }

    /** Returns id and meaning, because several rows have the same meaning. */
    String key() {
      byte[] first = segments.get(0);
      return HexFormat.of().formatHex(first, 0, Math.min(2, first.length)) + " " + meaning;
    }

    boolean isDatagram() {
      return type.startsWith("udp");
    }
  }

  private static List<Row> rows() {
    try {
      return Files.readAllLines(
              Path.of(
                  "../src/protocol/src/test/resources/no/hials/crosscom/protocol/c3-vectors.tsv"),
              StandardCharsets.UTF_8)
          .stream()
          .filter(line -> !line.startsWith("#"))
          .map(Row::parse)
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void startSubmit(MockServer server) throws Exception {
    server
        .controller()
        .load("SPS.SUB", "&ACCESS RVO\nDEF SPS()\nLOOP\nWAIT SEC 1.0\nENDLOOP\nEND\n");
    server.controller().submit().select("SPS");
    server.controller().submit().start();
  }

  private static void prepareStart(MockServer server) throws Exception {
    // ends the motions of the rows before
    server.controller().robot().stop();
    server.controller().robot().select("MAIN");
  }

  /** Sets the variables of the measured server that the rows show. */
  private static MockServer start() throws Exception {
    MockServer server =
        MockServer.start(
            cfg ->
                cfg.server(ServerType.C3_BRIDGE)
                    .computerName("VM")
                    .clock(SimulationClock.stepped())
                    .discoveryPort(0)
                    .discoveryReplyPort(0)
                    .standardDiscoveryPort(0));
    VariableTable table = server.variables();
    table.set("$OV_PRO", "100");
    table.set("$MODEL_NAME[]", "\"#KR6R900 C4\"");
    table.set("$IN[1]", "TRUE");
    table.set("$ACT_BASE", "1");
    table.set("$KR_SERIALNO", "123456");
    table.declare("MYBOOL", "BOOL", "FALSE");
    table.declare("MYCHAR[1]", "CHAR", "\"\u00C4\"");
    table.declare("MYUMLAUT[2]", "CHAR", "\"\u00C4\u20AC\"");
    table.declareEnum("STATES", "IDLE", "BUSY");
    table.declareStruc(
        "STRUC MYTYPE INT COUNT, BOOL FLAG, REAL RATIO, CHAR LABEL[10], STATES STATE");
    table.declare("MYSTRUCT", "MYTYPE", "{COUNT 0,FLAG TRUE,RATIO 0.0,LABEL[] \"x\",STATE #IDLE}");
    declareLong(table, "BIGVAR", 60_000);
    declareLong(table, "BIG66000", 66_000);
    server.controller().load("MAIN.SRC", "DEF MAIN()\nLOOP\nWAIT SEC 1.0\nENDLOOP\nEND\n");
    return server;
  }

  private static void declareLong(VariableTable table, String name, int length) {
    table.declareStruc("STRUC " + name + "TYPE CHAR TEXT[" + length + "]");
    table.declare(name, name + "TYPE", "{TEXT[] \"" + "x".repeat(length) + "\"}");
  }

  @Test
  void everyRowThatDoesNotDependOnTheStandInIsAnsweredByteForByte() throws Exception {
    List<String> compared = new ArrayList<>();
    List<String> leftOut = new ArrayList<>();
    long files = 0;
    List<String> wrong = new ArrayList<>();
    try (MockServer server = start()) {
      for (Row row : rows()) {
        before.getOrDefault(row.key(), s -> {}).run(server);
        if (isFile(row)) {
          files++;
          continue;
        }
        if (LEFT_OUT.containsKey(row.name())) {
          leftOut.add(row.name());
          continue;
        }
        compared.add(row.name());
        String found;
        try {
          found = row.isDatagram() ? ask(server, row) : exchange(server, row);
        } catch (IOException e) {
          found = e.toString();
        }
        String expected = expected(server, row);
        if (!found.equals(expected)) {
          wrong.add(row.name() + "\n  expected " + expected + "\n  found    " + found);
        }
      }
    }
    assertThat(wrong).isEmpty();
    assertThat(compared).hasSize(104);
    assertThat(leftOut).containsExactlyInAnyOrderElementsOf(LEFT_OUT.keySet());
    assertThat(files).isEqualTo(45);
  }

  /** Returns whether {@link FileVectorsTest} compares the row. */
  private static boolean isFile(Row row) {
    return row.type().matches("2[0-9]|30");
  }

  private static String expected(MockServer server, Row row) throws MalformedFrameException {
    byte[] answer = masked(withPort(row, server.port()));
    return HEX.formatHex(answer) + " " + (row.isDatagram() ? "" : row.fate());
  }

  /** Replaces the measured port by the port of this server. */
  private static byte[] withPort(Row row, int port) throws MalformedFrameException {
    byte[] answer = row.answer();
    byte[] request = row.segments().get(0);
    String asked = new String(request, StandardCharsets.ISO_8859_1).replace("\0", "");
    if (!asked.contains("@PROXY_PORT")) {
      return answer;
    }
    String now = String.valueOf(port);
    Response response = Codec.decodeResponse(answer, ServerType.C3_BRIDGE);
    if (response instanceof ValueResponse read) {
      return Codec.encode(
          new ValueResponse(read.id(), read.type(), read.value().replace(PORT, now), read.tail()));
    }
    if (response instanceof TextResponse text) {
      return Codec.encode(
          new TextResponse(text.id(), text.type(), text.text().replace(PORT, now), text.tail()));
    }
    MultipleResponse multiple = (MultipleResponse) response;
    List<AccessResult> results =
        multiple.results().stream()
            .map(result -> new AccessResult(result.code(), result.value().replace(PORT, now)))
            .toList();
    return Codec.encode(
        new MultipleResponse(multiple.id(), multiple.type(), results, multiple.tail()));
  }

  /** Removes the time from an answer of type 13. */
  private static byte[] masked(byte[] answer) {
    byte[] masked = answer.clone();
    if (masked.length > 24 && masked[4] == 13) {
      Arrays.fill(masked, 8, 24, (byte) 0);
    }
    return masked;
  }

  /** Sends the row on a new connection. Returns the answer and the state of the connection. */
  private static String exchange(MockServer server, Row row) throws Exception {
    try (RawClient client = new RawClient(server)) {
      for (byte[] segment : row.segments()) {
        client.send(segment);
      }
      if (row.meaning().contains("half close")) {
        client.endSending();
      }
      if (row.fate().equals("FIN")) {
        return HEX.formatHex(masked(HEX.parseHex(client.receiveAll()))) + " FIN";
      }
      return HEX.formatHex(masked(HEX.parseHex(answerBeforeProbe(client, row)))) + " open";
    }
  }

  /** Returns the bytes before the answer to one more request, which shows that no more come. */
  private static String answerBeforeProbe(RawClient client, Row row) throws IOException {
    String probe = "AB CD 00 07 00 00 04 50 49 4E 47";
    String answer = "AB CD 00 0A 00 00 04 50 4F 4E 47 00 01 01";
    if (row.meaning().startsWith("length 0")) {
      // the next byte closes the connection, as the next row shows
      return "";
    }
    if (row.meaning().startsWith("incomplete request")) {
      probe = "4F";
      answer = "01 E5 00 08 00 00 02 38 30 00 01 01";
    }
    client.send(probe);
    StringBuilder received = new StringBuilder(client.receive(1));
    while (!received.toString().endsWith(answer)) {
      received.append(' ').append(client.receive(1));
    }
    return received.substring(0, received.length() - answer.length()).strip();
  }

  /** Sends a datagram, and one that is always answered. Returns the first answer. */
  private static String ask(MockServer server, Row row) throws IOException {
    int port =
        row.type().equals("udp6999")
            ? server.discoveryPort().orElseThrow()
            : server.standardDiscoveryPort().orElseThrow();
    InetAddress host = InetAddress.getLoopbackAddress();
    try (DatagramSocket socket = new DatagramSocket(new InetSocketAddress(host, 0))) {
      socket.setSoTimeout(GIVE_UP_MILLIS);
      byte[] last = "@PROXY_ENABLED".getBytes(StandardCharsets.ISO_8859_1);
      byte[] first = row.segments().get(0);
      socket.send(new DatagramPacket(first, first.length, host, port));
      socket.send(new DatagramPacket(last, last.length, host, port));
      DatagramPacket answer = new DatagramPacket(new byte[1000], 1000);
      socket.receive(answer);
      assertThat(answer.getPort()).isEqualTo(port);
      byte[] bytes = Arrays.copyOf(answer.getData(), answer.getLength());
      boolean none =
          row.answerHex().isEmpty()
              && new String(bytes, StandardCharsets.ISO_8859_1).equals("TRUE");
      return HEX.formatHex(none ? new byte[0] : bytes) + " ";
    }
  }
}
