package no.hials.crosscom.kafka.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.Semaphore;
import no.hials.crosscom.cell.FileException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The plant file of a running connector. */
@Timeout(60)
class PlantWatchTest {
  private static final String VALID = "[robots.r1]\nhost = \"127.0.0.1\"\n";

  @TempDir private Path folder;
  private final Semaphore changes = new Semaphore(0);

  private PlantWatch watch(Path file, Duration period) {
    return new PlantWatch(file.toString(), changes::release, period);
  }

  @Test
  void aFileThatIsInvalidAtTheStartIsTakenOnceItIsValid() throws Exception {
    Path file = Files.writeString(folder.resolve("plant.toml"), VALID + "[half");
    try (PlantWatch watch = watch(file, Duration.ofMillis(10))) {
      assertThatThrownBy(watch::text)
          .isInstanceOf(FileException.class)
          .hasMessageContaining("plant.toml:3");
      Files.writeString(file, VALID);
      changes.acquire();
      assertThat(watch.text()).isEqualTo(VALID);
    }
  }

  @Test
  void aFileThatBecomesInvalidStaysAsItWas() throws Exception {
    Path file = Files.writeString(folder.resolve("plant.toml"), VALID);
    // only the test looks
    try (PlantWatch watch = watch(file, Duration.ofHours(1))) {
      Files.writeString(file, VALID + "[half");
      watch.look();
      assertThat(watch.text()).isEqualTo(VALID);
      assertThat(changes.availablePermits()).isZero();
      String other = VALID.replace("r1", "r2");
      Files.writeString(file, other);
      watch.look();
      assertThat(changes.availablePermits()).isOne();
      assertThat(watch.text()).isEqualTo(other);
    }
  }
}
