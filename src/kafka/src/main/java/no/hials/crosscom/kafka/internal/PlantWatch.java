package no.hials.crosscom.kafka.internal;

import java.time.Duration;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.cell.DaemonThreadFactory;
import no.hials.crosscom.cell.FileException;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Checks the plant file of a connector for changes every few seconds. */
public final class PlantWatch implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(PlantWatch.class);

  private final String file;
  private final Runnable changed;
  private final ScheduledExecutorService timer =
      Executors.newSingleThreadScheduledExecutor(DaemonThreadFactory.named("jopenshowvar-plant"));
  private @Nullable String text;
  private String complaint = "";

  /**
   * Reads the file, also if it is invalid now: otherwise nobody would see that it is valid again.
   *
   * @param changed called when the file has changed and is valid
   */
  public PlantWatch(String file, Runnable changed) {
    this(file, changed, Duration.ofSeconds(5));
  }

  PlantWatch(String file, Runnable changed, Duration period) {
    this.file = file;
    this.changed = changed;
    try {
      text = ConnectorSettings.plantText(file);
    } catch (FileException e) {
      complaint = String.valueOf(e.getMessage());
      LOG.warn("the connector has started without a valid plant, and waits for one: {}", complaint);
    }
    ScheduledFuture<?> unused =
        timer.scheduleWithFixedDelay(
            this::look, period.toMillis(), period.toMillis(), TimeUnit.MILLISECONDS);
  }

  void look() {
    try {
      if (accept(ConnectorSettings.plantText(file))) {
        LOG.info("{} has changed: the tasks restart with it", file);
        changed.run();
      }
    } catch (FileException | RuntimeException | Error e) {
      // also an error, such as one of memory: otherwise this would be the last look
      complain(String.valueOf(e.getMessage()));
    }
  }

  /** Keeps a valid text, and returns whether it differs from the one before. */
  private synchronized boolean accept(String now) {
    complaint = "";
    boolean different = !now.equals(text);
    text = now;
    return different;
  }

  private synchronized void complain(String message) {
    if (!message.equals(complaint)) {
      LOG.warn(
          "{}: {}", text == null ? "no valid plant yet" : "the plant stays as it was", message);
    }
    complaint = message;
  }

  /**
   * Returns the last valid text of the file.
   *
   * @throws FileException if the file has not been valid since the start
   */
  public synchronized String text() throws FileException {
    if (text == null) {
      throw new FileException(complaint);
    }
    return text;
  }

  @Override
  public void close() {
    timer.shutdownNow();
  }
}
