package no.hials.crosscom.cell.recording;

import java.io.IOException;
import java.time.Duration;
import no.hials.crosscom.Sample;
import no.hials.crosscom.cell.SampledRobot;

/** Writes a line of JSON for each sample, with the number of failed readings. */
public final class JsonRecording implements Recording {
  private final RecordingOutput output;

  public JsonRecording(RecordingOutput output) {
    this.output = output;
  }

  @Override
  public void add(SampledRobot robot, Sample sample, Duration since) {
    output.write(SampleJson.of(robot, sample, since) + "\n");
  }

  @Override
  public void close() throws IOException {
    output.close();
  }
}
