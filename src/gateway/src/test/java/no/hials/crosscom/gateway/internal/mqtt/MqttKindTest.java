package no.hials.crosscom.gateway.internal.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.gateway.Gateway;
import no.hials.crosscom.gateway.GatewayConfig;
import no.hials.crosscom.gateway.OutputKind;
import no.hials.crosscom.gateway.internal.sparkplug.SparkplugId;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MqttKindTest {
  @TempDir private Path folder;
  @KukaController private MockServer robot;

  private MqttSettings read(String... lines) throws FileException {
    String text = "[mqtt]\n" + String.join("\n", lines);
    return new MqttKind().read(TomlTable.parse(folder.resolve("plant.toml"), text).table("mqtt"));
  }

  @Test
  void hasDefaultsForAllButTheUrl() throws Exception {
    MqttSettings settings = read("url = \"tcp://[::1]\"");

    assertThat(settings.broker().url()).isEqualTo("tcp://[::1]:1883");
    assertThat(settings.broker().version()).isEqualTo(5);
    assertThat(settings.broker().storeLimit()).isEqualTo(100_000_000);
    assertThat(settings.topic()).isEqualTo("robots");
    assertThat(settings.qos()).isEqualTo(1);
    assertThat(settings.commands()).isFalse();
    assertThat(settings.sparkplug()).isNull();
  }

  @Test
  void readsAllKeys() throws Exception {
    Files.writeString(folder.resolve("password"), "secret");

    MqttSettings settings =
        read(
            "url = \"ssl://broker\"",
            "version = 3",
            "client-id = \"gw\"",
            "user = \"me\"",
            "password-file = \"password\"",
            "topic = \"plant/hall\"",
            "qos = 0",
            "store-limit = \"2 GB\"",
            "commands = true",
            "sparkplug-group = \"g\"",
            "sparkplug-node = \"n\"");

    assertThat(settings.broker().url()).isEqualTo("ssl://broker:8883");
    assertThat(settings.broker().passwordFile()).isEqualTo(folder.resolve("password"));
    assertThat(settings.broker().storeLimit()).isEqualTo(2_000_000_000);
    assertThat(settings.sparkplug()).isEqualTo(new SparkplugId("g", "n"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "url = \"http://broker\" | :3: mqtt.url: must be like tcp://host:1883 or ssl://host:8883",
        "url = \"tcp://broker/path\" | mqtt.url: must be like",
        "url = \"tcp://robot:secret@broker\" | mqtt.url: must be like tcp://host:1883 or ssl://host:8883, is tcp://...@broker",
        "url = \"robot:se//c ret@broker\" | mqtt.url: must be like tcp://host:1883 or ssl://host:8883, is ...@broker",
        "version = 4 | :3: mqtt.version: must be 3 (MQTT 3.1.1) or 5, is 4",
        "qos = 3 | mqtt.qos: must be 0, 1 or 2, is 3",
        "client-id = \"\" | mqtt.client-id: must not be empty; without it the identifier is random",
        "topic = \"a/#\" | mqtt.topic: must not be empty, begin with $",
        "topic = \"a\\nb\\nc\" | mqtt.topic: must not be empty, begin with $",
        "topic = \"spBv1.0\" | mqtt.topic: must not begin with spBv1.0, the namespace of Sparkplug",
        "topic = \"spBv1.0/g\" | mqtt.topic: must not begin with spBv1.0",
        "store-limit = \"10 kB\" | mqtt.store-limit: must be 100 kB or more",
        "store-limit = \"much\" | mqtt.store-limit: must be like 500 kB, 100 MB or 2 GB, is much",
        "password-file = \"x\" | mqtt.password-file: needs a user",
        "ca-file = \"x\" | mqtt.ca-file: needs a url that begins with ssl://",
        "sparkplug-group = \"g\" | sparkplug-group and sparkplug-node need each other",
        "sparkplug-group = \"a/b\" | mqtt.sparkplug-group: must not have a slash in it",
        "clientid = \"g\" | mqtt.clientid: no such key; known: url, version",
      })
  void refusesWhatIsWrongWithLineAndRule(String line, String message) {
    String[] lines =
        line.startsWith("url")
            ? new String[] {"", line}
            : new String[] {"url = \"tcp://broker:1883\"", line};
    assertThatExceptionOfType(FileException.class)
        .isThrownBy(() -> read(lines))
        .withMessageContaining("plant.toml:")
        .withMessageContaining(message);
  }

  @Test
  void refusesTheGroupOfHostApplications() {
    assertThatExceptionOfType(FileException.class)
        .isThrownBy(
            () ->
                read(
                    "url = \"tcp://broker\"",
                    "sparkplug-group = \"STATE\"",
                    "sparkplug-node = \"n\""))
        .withMessageContaining(":3: mqtt.sparkplug-group: must not be STATE");
  }

  @Test
  void refusesFilesThatAreMissingOrEmptyOrNoCertificates() throws Exception {
    Files.writeString(folder.resolve("empty"), "\n");
    Files.writeString(folder.resolve("ca.pem"), "no certificate");
    String url = "url = \"ssl://broker\"";

    assertThatExceptionOfType(FileException.class)
        .isThrownBy(() -> read(url, "user = \"me\"", "password-file = \"none\""))
        .withMessageContaining("mqtt.password-file: cannot read");
    assertThatExceptionOfType(FileException.class)
        .isThrownBy(() -> read(url, "user = \"me\"", "password-file = \"empty\""))
        .withMessageContaining("mqtt.password-file: ")
        .withMessageContaining("has no password");
    assertThatExceptionOfType(FileException.class)
        .isThrownBy(() -> read(url, "ca-file = \"ca.pem\""))
        .withMessageContaining("mqtt.ca-file: ");
    assertThatExceptionOfType(FileException.class)
        .isThrownBy(() -> read("qos = 1"))
        .withMessageContaining("needs the url of the broker");
  }

  @Test
  void namesCannotBreakOutOfTheirLevelOfATopic() {
    Topics topics = new Topics("robots");

    assertThat(topics.variable("a/b", "X+#%")).isEqualTo("robots/a%2Fb/X%2B%23%25");
    assertThat(topics.target("robots/a%2Fb/X%2B%23%25/set")).containsExactly("a/b", "X+#%");
    assertThat(topics.target("robots/a/b/c/set")).isNull();
    assertThat(topics.target("robots/set")).isNull();
  }

  @Test
  @Timeout(60)
  void twoGatewaysCannotUseOneFolder(@TempDir Path data) throws Exception {
    List<OutputKind<?>> kinds = List.of(new MqttKind());
    TomlTable root =
        TomlTable.parse(
            folder.resolve("plant.toml"),
            """
            [robots.cell1]
            host = "%s:%d"
            [mqtt]
            url = "tcp://%s:%d"
            """
                .formatted(robot.host(), robot.port(), robot.host(), robot.port()));
    GatewayConfig config = GatewayConfig.read(root, data, Map.of(), kinds);

    try (Gateway first = Gateway.start(config, kinds, RobotConnection::openLazily)) {
      assertThatExceptionOfType(IOException.class)
          .isThrownBy(() -> Gateway.start(config, kinds, RobotConnection::openLazily))
          .withMessageContaining("another gateway uses " + data.resolve("mqtt-store"));
      assertThat(first.robots()).hasSize(1);
    }

    Gateway.start(config, kinds, RobotConnection::openLazily).close();
  }
}
