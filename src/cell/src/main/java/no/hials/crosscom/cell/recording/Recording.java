package no.hials.crosscom.cell.recording;

import java.io.Closeable;
import java.time.Duration;
import no.hials.crosscom.ConnectionEvent;
import no.hials.crosscom.Sample;
import no.hials.crosscom.cell.SampledRobot;
import no.hials.crosscom.cell.Sampling;

/** Writes samples to a file, each one immediately. */
public interface Recording extends Closeable {

  /** The destination of the text of a recording. */
  interface RecordingOutput extends Closeable {
    /**
     * Writes a text.
     *
     * @throws OutputException if the text cannot be written
     */
    void write(String text);
  }

  /** Writes the beginning of the recording, before the samples. */
  default void begin() {}

  /**
   * Writes a sample.
   *
   * @param since the time since the first sample
   */
  void add(SampledRobot robot, Sample sample, Duration since);

  /** Called when a connection is lost or restored. */
  default void connectionChanged(SampledRobot robot, ConnectionEvent event) {}

  /** Writes the end of the recording, after the samples. */
  default void end(Sampling sampling) {}
}
