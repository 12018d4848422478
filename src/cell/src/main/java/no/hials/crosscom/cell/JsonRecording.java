package no.hials.crosscom.cell;

import java.io.IOException;
import java.time.Duration;
import no.hials.crosscom.Sample;

/** Writes a line of JSON for each sample, which also has the number of failed readings. */
public final class JsonRecording implements Recording {
  private final Sink sink;

  public JsonRecording(Sink sink) {
    this.sink = sink;
  }

  @Override
  public void add(SampledRobot robot, Sample sample, Duration since) {
    sink.write(SampleJson.of(robot, sample, since) + "\n");
  }

  @Override
  public void close() throws IOException {
    sink.close();
  }
}
