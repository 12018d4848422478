package no.hials.crosscom.gateway.internal.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RetainedTopicsTest {
  private static final String BROKER = "tcp://127.0.0.1:1883";

  @TempDir private Path folder;

  private RetainedTopics open() {
    return new RetainedTopics(folder.resolve("data/retained"), BROKER);
  }

  @Test
  void theNextRunKnowsTheTopics() {
    RetainedTopics first = open();
    first.add("robots/cell1/$OV_PRO");
    first.add("robots/cell1/KÄSE");
    first.add("robots/cell1/$MODE_OP");
    first.remove("robots/cell1/$OV_PRO");
    first.save();

    assertThat(open().without(Set.of("robots/cell1/$MODE_OP")))
        .containsExactly("robots/cell1/KÄSE");
  }

  @Test
  void topicsOfAnotherBrokerAreForgotten() {
    RetainedTopics first = open();
    first.add("robots/cell1/$OV_PRO");
    first.save();

    RetainedTopics other = new RetainedTopics(folder.resolve("data/retained"), "tcp://host:1883");

    assertThat(other.without(Set.of())).isEmpty();
  }

  @Test
  void aFileThatCannotBeReadIsNotReplaced() throws IOException {
    Path file = folder.resolve("data/retained");
    Files.createDirectories(file); // a folder cannot be read as a file
    RetainedTopics topics = open();
    topics.add("robots/cell1/$OV_PRO");
    topics.save();
    assertThat(file).isDirectory();

    Files.delete(file);
    Files.writeString(file, BROKER + "\nrobots/cell2/$OV_PRO\n");
    topics.save();

    assertThat(file).hasContent(BROKER + "\nrobots/cell1/$OV_PRO\nrobots/cell2/$OV_PRO");
  }

  @Test
  void theFileIsWrittenAgainAfterAFailure() throws IOException {
    RetainedTopics topics = open();
    Files.writeString(folder.resolve("data"), "in the way of the folder");
    topics.add("robots/cell1/$OV_PRO");
    topics.save();
    Files.delete(folder.resolve("data"));

    topics.save();

    assertThat(open().without(Set.of())).containsExactly("robots/cell1/$OV_PRO");
  }
}
