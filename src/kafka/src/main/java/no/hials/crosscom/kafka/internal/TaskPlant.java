package no.hials.crosscom.kafka.internal;

import java.nio.file.Path;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.cell.feed.Plant;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The plant of a task, and its file. The connector watches the file, but not while it is paused,
 * and when it is resumed its tasks go on before they get the new plant. So a task that writes looks
 * itself. Thread-safe.
 */
public final class TaskPlant {
  private static final Logger LOG = LoggerFactory.getLogger(TaskPlant.class);

  private final Path file;
  private final String text;
  private final Plant plant;

  /** Why nothing is written, so that it is logged once. */
  private String complaint = "";

  /**
   * Reads a plant.
   *
   * @param file the file on the worker of the task
   * @param text the text that the connector has read
   * @throws FileException if the text is not valid
   */
  public TaskPlant(String file, String text) throws FileException {
    this.file = Path.of(file);
    this.text = text;
    this.plant = PlantText.read(file, text);
  }

  /** Returns the plant. */
  public Plant plant() {
    return plant;
  }

  /** Reads the file, and returns whether it still has the text of the plant. */
  public synchronized boolean isCurrent() {
    String now = "";
    try {
      if (!TomlTable.textOf(file).equals(text)) {
        now = file + " on this worker differs from the plant of the task";
      }
    } catch (FileException e) {
      now = String.valueOf(e.getMessage());
    }
    if (!now.isEmpty() && !now.equals(complaint)) {
      LOG.warn("nothing is written until the file is as before or the task restarts: {}", now);
    }
    complaint = now;
    return now.isEmpty();
  }
}
