package no.hials.crosscom.gateway.internal.mqtt;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.cell.feed.Plant;
import no.hials.crosscom.cell.feed.PlantFile;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.gateway.Health;
import no.hials.crosscom.gateway.OneRobotContext;
import no.hials.crosscom.gateway.internal.broker.CommandQueue;
import no.hials.crosscom.gateway.internal.broker.Publication;
import no.hials.crosscom.gateway.internal.broker.Received;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The limit of the topics and the correlation data of a command. */
@Timeout(60)
class TopicCommandsTest {
  private static final String SET = "robots/nobody/MYINT/set";

  @KukaController private MockServer server;
  @TempDir private Path folder;

  /** Returns the topics of the answers to a command for a robot that does not exist. */
  private List<String> answers(String responseTopic, int correlation) throws Exception {
    String text = "[robots.cell1]\nhost = \"" + server.host() + ":" + server.port() + "\"\n";
    Plant plant = PlantFile.read(TomlTable.parse(Path.of("plant.toml"), text), Map.of());
    MqttSettings settings =
        new MqttKind()
            .read(
                TomlTable.parse(folder.resolve("plant.toml"), "[mqtt]\nurl = \"tcp://127.0.0.1\"\n")
                    .table("mqtt"));
    List<Publication> answers = new ArrayList<>();
    try (RobotFeed feed =
            RobotFeed.open(plant.plans().get(0), RobotConnection::open, (one, updates) -> {});
        CommandQueue queue =
            new CommandQueue(new OneRobotContext(plant, feed, folder, new Health()))) {
      new TopicCommands(settings, queue, answers::add)
          .receive(
              new Received(
                  SET,
                  ByteBuffer.wrap("1".getBytes(UTF_8)),
                  false,
                  "",
                  responseTopic,
                  ByteBuffer.allocate(correlation),
                  null));
    }
    return answers.stream().map(Publication::topic).toList();
  }

  @Test
  void topicsAreMeasuredInBytes() throws Exception {
    String response = "ü".repeat(400); // 800 bytes
    int left = 1000 - SET.length() - 800;

    assertThat(answers(response, left)).containsExactly(SET + "/result", response);
    assertThat(answers(response, left + 1)).isEmpty();
  }
}
