package no.hials.crosscom.kafka;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.apache.kafka.connect.connector.Connector;
import org.apache.kafka.connect.errors.ConnectException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The answers to wrong configurations of the connectors. */
class ConnectorValidationTest {
  @TempDir private Path folder;
  private final Map<String, String> source = new HashMap<>();
  private final Map<String, String> sink = new HashMap<>();

  @BeforeEach
  void prepare() throws Exception {
    Path plant = folder.resolve("plant.toml");
    Files.writeString(plant, "[robots.r1]\nhost = \"127.0.0.1\"\n");
    source.put("plant", plant.toString());
    sink.put("plant", plant.toString());
    sink.put("writes.enabled", "true");
    sink.put("bootstrap.servers", "127.0.0.1:9092");
    sink.put("audit.folder", folder.toString());
    sink.put("errors.tolerance", "all");
    sink.put("errors.deadletterqueue.topic.name", "dead");
    sink.put("producer.override.delivery.timeout.ms", "30000");
    sink.put("producer.override.acks", "all");
  }

  /** Returns the errors, each with its property before it. */
  private static List<String> errors(Connector connector, Map<String, String> properties) {
    return connector.validate(properties).configValues().stream()
        .flatMap(value -> value.errorMessages().stream().map(error -> value.name() + ": " + error))
        .toList();
  }

  @Test
  void rightConfigurationsHaveNoError() {
    assertThat(errors(new RobotSourceConnector(), source)).isEmpty();
    assertThat(errors(new RobotSinkConnector(), sink)).isEmpty();
    source.put("topic", "plant.{robot}");
    source.put("producer.override.acks", "1");
    sink.put("producer.override.acks", "-1");
    assertThat(errors(new RobotSinkConnector(), sink)).isEmpty();
    assertThat(errors(new RobotSourceConnector(), source)).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '"',
      textBlock =
          """
          plant,               "",                   must be non-empty
          plant,               /missing.toml,        file not found
          topic,               "",                   must be letters
          topic,               a b,                  must be letters
          topic,               ..,                   must be letters
          lease.topic,         robots,               must not be the topic of the samples
          lease.topic,         leases-{robot},       must be letters
          lease.topic,         "",                   must be letters
          lease.ms,            499,                  at least 500
          lease.ms,            abc,                  Not a number
          lease.ms,            9223372036854775807,  no more than 3600000
          lease.recovery.ms,   9223372036854775807,  no more than 3600000
          buffer.records,      2147483647,           no more than 1000000
          producer.override.acks,  0,                must not be 0
          """)
  void aWrongPropertyOfTheSourceIsNamed(String key, String value, String rule) {
    source.put(key, value);
    assertThat(errors(new RobotSourceConnector(), source))
        .singleElement()
        .asString()
        .startsWith(key + ": ")
        .contains(rule);
  }

  @Test
  void aPathWithAForbiddenCharacterIsNamed() {
    source.put("plant", "a\0b");
    assertThat(errors(new RobotSourceConnector(), source))
        .singleElement()
        .asString()
        .contains("Nul");
    sink.put("audit.folder", "a\0b");
    assertThat(errors(new RobotSinkConnector(), sink)).singleElement().asString().contains("Nul");
  }

  @Test
  void theTasksOfASinkThatStartsWithoutAValidPlantFailWithTheReason() throws Exception {
    Files.writeString(folder.resolve("plant.toml"), "[half");
    sink.put("name", "writes");
    RobotSinkConnector connector = new RobotSinkConnector();
    connector.start(sink);
    Map<String, String> task = connector.taskConfigs(1).get(0);
    connector.stop();
    assertThatThrownBy(() -> new RobotSinkTask().start(task))
        .isInstanceOf(ConnectException.class)
        .hasMessageContaining("plant.toml:1");
  }

  @Test
  void aSourceThatStartsWithoutAValidPlantKeepsItsTasks() throws Exception {
    Files.writeString(folder.resolve("plant.toml"), "[half");
    RobotSourceConnector connector = new RobotSourceConnector();
    connector.start(source);
    assertThatThrownBy(() -> connector.taskConfigs(1))
        .isInstanceOf(ConnectException.class)
        .hasMessageContaining("the tasks stay as they are")
        .hasMessageContaining("plant.toml:1");
    connector.stop();
  }

  @Test
  void theTopicsAreCheckedWithTheNamesOfTheRobots() {
    source.put("topic", "robots-{robot}");
    source.put("lease.topic", "robots-r1");
    assertThat(errors(new RobotSourceConnector(), source))
        .singleElement()
        .asString()
        .startsWith("lease.topic: ")
        .contains("must not be the topic of the samples");
    source.remove("lease.topic");
    source.put("topic", "x".repeat(248) + "{robot}");
    assertThat(errors(new RobotSourceConnector(), source))
        .singleElement()
        .asString()
        .startsWith("topic: ")
        .contains("at most 249");
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '"',
      textBlock =
          """
          audit.folder,        "",         must be non-empty
          bootstrap.servers,   "",         You must set either bootstrap.servers
          bootstrap.servers,   nonsense,   Invalid url in bootstrap.servers: nonsense
          max.age.ms,          0,          at least 1
          max.age.ms,          31536000001,  no more than 31536000000
          errors.tolerance,    none,       must be all
          errors.deadletterqueue.topic.name,      "",     must be non-empty
          producer.override.delivery.timeout.ms,  60001,  no more than 60000
          producer.override.acks,  0,             must be all
          producer.override.acks,  1,             must be all
          """)
  void aWrongPropertyOfTheSinkIsNamed(String key, String value, String rule) {
    sink.put(key, value);
    assertThat(errors(new RobotSinkConnector(), sink))
        .singleElement()
        .asString()
        .startsWith(key + ": ")
        .contains(rule);
  }

  @Test
  void theSinkNeedsADeadLetterTopicThatConfirmsWithinALimit() {
    sink.keySet().removeAll(Set.of("errors.tolerance", "errors.deadletterqueue.topic.name"));
    sink.remove("producer.override.delivery.timeout.ms");
    sink.remove("producer.override.acks");
    assertThat(errors(new RobotSinkConnector(), sink))
        .extracting(error -> error.substring(0, error.indexOf(':')))
        .containsExactlyInAnyOrder(
            "errors.tolerance",
            "errors.deadletterqueue.topic.name",
            "producer.override.delivery.timeout.ms",
            "producer.override.acks");
  }

  @Test
  void aWrongSettingOfTheClientOfTheBrokersIsNamed() {
    sink.put("admin.security.protocol", "NONE");
    assertThat(errors(new RobotSinkConnector(), sink)).singleElement().asString().contains("NONE");
  }
}
