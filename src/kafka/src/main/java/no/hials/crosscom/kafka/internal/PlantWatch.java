package no.hials.crosscom.kafka.internal;

import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.cell.FileException;
import org.apache.kafka.connect.errors.ConnectException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Checks the plant file of a connector for changes every few seconds. */
public final class PlantWatch implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(PlantWatch.class);
  private static final long SECONDS = 5;

  private final String file;
  private final Runnable changed;
  private final ScheduledExecutorService timer =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread thread = new Thread(task, "jopenshowvar-plant");
            thread.setDaemon(true);
            return thread;
          });
  private volatile String text;
  private String complaint = "";

  /**
   * Reads the file.
   *
   * @param changed called when the file has changed and is valid
   * @throws ConnectException if the file is invalid now
   */
  public PlantWatch(String file, Runnable changed) {
    this.file = file;
    this.changed = changed;
    try {
      text = ConnectorSettings.plantText(file);
    } catch (FileException e) {
      timer.shutdownNow();
      throw new ConnectException(e.getMessage(), e);
    }
    ScheduledFuture<?> unused =
        timer.scheduleWithFixedDelay(this::look, SECONDS, SECONDS, TimeUnit.SECONDS);
  }

  private void look() {
    try {
      String now = ConnectorSettings.plantText(file);
      complaint = "";
      if (!now.equals(text)) {
        text = now;
        LOG.info("{} has changed: the tasks restart with it", file);
        changed.run();
      }
    } catch (FileException | RuntimeException e) {
      String message = String.valueOf(e.getMessage());
      if (!message.equals(complaint)) {
        LOG.warn("the plant stays as it was: {}", message);
      }
      complaint = message;
    }
  }

  /** Returns the last valid text of the file. */
  public String text() {
    return text;
  }

  @Override
  public void close() {
    timer.shutdownNow();
  }
}
