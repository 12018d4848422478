package no.hials.crosscom.lab.bench;

import de.siegmar.fastcsv.writer.CsvWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Objects;
import java.util.concurrent.locks.ReentrantLock;
import no.hials.crosscom.cell.TimeText;
import no.hials.crosscom.cell.recording.CsvText;
import no.hials.crosscom.cell.recording.OutputException;

/** Writes each access that {@code bench} measures as a line of a CSV file. */
public final class BenchCsv implements Bench.BenchListener, AutoCloseable {
  private final Path file;
  private final CsvWriter csv;
  private final ReentrantLock lock = new ReentrantLock();

  public BenchCsv(Path file) {
    this.file = file;
    try {
      csv = CsvWriter.builder().build(file);
      csv.writeRecord("seconds", "client", "access", "name", "access_ms", "failure");
    } catch (IOException e) {
      throw new OutputException(file.toString(), e);
    }
  }

  @Override
  public void add(long nanos, int client, BenchAccess access, long took, String failure) {
    lock.lock();
    try {
      csv.writeRecord(
          TimeText.seconds(Duration.ofNanos(nanos)),
          Integer.toString(client),
          access.verb(),
          CsvText.guarded(access.name()),
          failure.isEmpty() ? TimeText.millis(Duration.ofNanos(took)) : "",
          failure);
    } catch (UncheckedIOException e) {
      throw new OutputException(file.toString(), Objects.requireNonNull(e.getCause()));
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void close() {
    try {
      csv.close();
    } catch (IOException e) {
      throw new OutputException(file.toString(), e);
    }
  }
}
