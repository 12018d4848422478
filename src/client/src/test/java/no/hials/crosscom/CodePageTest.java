package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.time.Duration;
import java.util.List;
import java.util.Random;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLString;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.Parameter;
import org.junit.jupiter.params.ParameterizedClass;
import org.junit.jupiter.params.provider.ValueSource;

/** Names and values of any script on a C3 Bridge, on Windows with several code pages. */
@ParameterizedClass
@ValueSource(ints = {936, 1251, 1252})
class CodePageTest {
  private static final int ROUNDS = 150;

  /** ASCII, letters of several code pages, letters with a best fit, and characters of two units. */
  private static final List<String> CHARACTERS =
      List.of(
          "a", "Z", "5", " ", "?", "{", ",", "#", "ö", "ß", "µ", "€", "Ł", "ź", "П", "я", "你", "好",
          "Ω", "𠮷");

  @Parameter int page;

  private final Random random = new Random(Long.getLong("seed", 1));
  private MockServer robot;
  private CrossComClient client;

  /** A structure with a text. */
  private record Label(String text, int count) {}

  @BeforeEach
  void connect() throws Exception {
    robot = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE).codePage(page));
    robot.variables().declare("TEXT[100]", "CHAR", "\"\"");
    robot.variables().declareStruc("STRUC LABEL CHAR TEXT[100], INT COUNT");
    robot.variables().declare("MYLABEL", "LABEL", "{TEXT[] \"x\",COUNT 1}");
    client =
        new CrossComClient(
            ClientConfig.create(
                robot.host(), cfg -> cfg.port(robot.port()).keepAlive(Duration.ZERO)));
  }

  @AfterEach
  void disconnect() throws Exception {
    client.close();
    robot.close();
  }

  private String anyText() {
    StringBuilder text = new StringBuilder("x"); // one blank is the empty text
    for (int i = random.nextInt(20); i > 0; i--) {
      text.append(CHARACTERS.get(random.nextInt(CHARACTERS.size())));
    }
    return text.append(".").toString();
  }

  /** Checks that messages 0 and 1 carried nothing that a code page can change. */
  private void assertThatMessages0And1ArePlain() {
    assertThat(robot.requests())
        .filteredOn(
            r ->
                r.request() != null
                    && (r.request().type() == MessageType.READ
                        || r.request().type() == MessageType.WRITE))
        .allSatisfy(
            r -> {
              assertThat(r.name()).matches("\\p{ASCII}*");
              assertThat(r.value() == null ? "" : r.value()).matches("[\\p{ASCII}&&[^\"]]*");
            });
    robot.clearRequests();
  }

  @Test
  void aTextWrittenByAnyCallIsStoredAndReadExactly() throws Exception {
    for (int i = 0; i < ROUNDS; i++) {
      String text = anyText();
      write(i % 6, text);
      assertThat(robot.variables().get("TEXT[]")).isEqualTo('"' + text + '"');
      assertThat(read(i % 7)).isEqualTo(text);

      client.write("MYLABEL", new Label(text, i));
      assertThat(robot.variables().get("MYLABEL.TEXT[]")).isEqualTo('"' + text + '"');
      assertThat(client.read("MYLABEL", Label.class)).isEqualTo(new Label(text, i));
      assertThatMessages0And1ArePlain();
    }
  }

  @SuppressWarnings("deprecation")
  private void write(int how, String text) throws Exception {
    KRLString variable = new KRLString("TEXT[]");
    variable.setValue(text);
    switch (how) {
      case 0 -> client.writeVariable(variable);
      case 1 -> client.writeText("TEXT[]", '"' + text + '"');
      case 2 -> client.writeString("TEXT[]", text);
      case 3 -> client.writeVariables(variable, variable).get(1).orThrow();
      case 4 -> client.simpleWrite("TEXT[]", '"' + text + '"');
      default -> client.sendRequest(new Request(0, "TEXT[]", '"' + text + '"'));
    }
  }

  @SuppressWarnings("deprecation")
  private String read(int how) throws Exception {
    KRLString variable = new KRLString("TEXT[]");
    return switch (how) {
      case 0 -> client.read(variable).getValue();
      case 1 -> client.readText("TEXT[]").replace("\"", "");
      case 2 -> client.readString("TEXT[]");
      case 3 -> {
        client.readVariables(variable, new KRLInt("MYINT")).get(0).orThrow();
        yield variable.getValue();
      }
      case 4 -> client.readValue("TEXT[]").asString();
      case 5 -> client.simpleRead("TEXT[]").replaceFirst(".*#value=", "").replace("\"", "");
      default -> client.sendRequest(new Request(0, "TEXT[]")).getStringValue().replace("\"", "");
    };
  }

  @Test
  void aNameOfAnyScriptIsNotTakenForASimilarOne() throws Exception {
    client.readInt("MYINT");
    for (int i = 0; i < ROUNDS; i++) {
      String name = "MYINT" + anyText().replaceAll("[\\p{ASCII}]", "") + "Ł";
      robot.variables().set("MYINT", "7");
      List<CrossComAction> accesses =
          List.of(
              c -> c.readText(name),
              c -> c.readInt(name),
              c -> c.readReal(name),
              c -> c.readRealArray(name),
              c -> c.writeInt(name, 5),
              c -> c.writeText(name, "5"),
              c -> c.writeBool(name, true),
              c -> c.readVariables(new KRLInt(name), new KRLInt("MYINT")).get(0).orThrow());
      for (CrossComAction access : accesses) {
        assertThatExceptionOfType(CrossComAccessException.class)
            .isThrownBy(() -> access.run(client));
      }
      assertThat(robot.variables().get("MYINT")).isEqualTo("7");
      assertThatMessages0And1ArePlain();
    }
  }
}
