package no.hials.crosscom.cell;

import java.io.Closeable;
import java.time.Duration;
import no.hials.crosscom.ConnectionEvent;
import no.hials.crosscom.Sample;

/** A file of samples that is being written; what is given to it is in the file at once. */
public interface Recording extends Closeable {

  /** Where the text of a recording goes. */
  interface Sink extends Closeable {
    /**
     * Writes a text.
     *
     * @throws OutputException if it cannot be written
     */
    void write(String text);
  }

  /** Writes what stands before the samples. */
  void begin();

  /**
   * Writes a sample.
   *
   * @param since the time since the first sample
   */
  void add(SampledRobot robot, Sample sample, Duration since);

  /** Called when a connection is lost or restored. */
  void connectionChanged(SampledRobot robot, ConnectionEvent event);

  /** Writes the end of the recording, after the samples. */
  void end(Sampling sampling);
}
