package no.hials.crosscom.cell.recording;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.time.Duration;
import java.util.Map;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.Sample;
import no.hials.crosscom.Sample.Reading;
import no.hials.crosscom.cell.JsonLine;
import no.hials.crosscom.cell.SampledRobot;
import no.hials.crosscom.cell.TimeText;
import no.hials.crosscom.protocol.value.KrlValue;

/** Prints a sample as one line of JSON; the help of {@code watch} describes it. */
public final class SampleJson {
  private SampleJson() {}

  /**
   * Prints a sample.
   *
   * @param since the time since the first sample
   */
  public static String of(SampledRobot robot, Sample sample, Duration since) {
    return JsonLine.object(
        json -> {
          json.writeStringField("time", TimeText.instant(sample.time()));
          writeNumber(json, "seconds", TimeText.seconds(since));
          if (!robot.name().isEmpty()) {
            json.writeStringField("robot", robot.name());
          }
          writeNumber(json, "access_ms", TimeText.millis(sample.duration()));
          json.writeNumberField("missed", sample.missedPeriods());
          json.writeNumberField("failed", sample.failedPolls());
          writeValues(json, sample);
          writeErrors(json, sample);
          json.writeArrayFieldStart("changed");
          for (String name : sample.readings().keySet()) {
            if (sample.changed().contains(name)) {
              json.writeString(name);
            }
          }
          json.writeEndArray();
        });
  }

  private static void writeNumber(JsonGenerator json, String name, String number)
      throws IOException {
    json.writeFieldName(name);
    json.writeNumber(number);
  }

  private static void writeValues(JsonGenerator json, Sample sample) throws IOException {
    json.writeObjectFieldStart("values");
    for (Map.Entry<String, Reading> reading : sample.readings().entrySet()) {
      KrlValue value = reading.getValue().value();
      if (value != null) {
        json.writeFieldName(reading.getKey());
        JsonLine.write(json, value);
      }
    }
    json.writeEndObject();
  }

  private static void writeErrors(JsonGenerator json, Sample sample) throws IOException {
    json.writeObjectFieldStart("errors");
    for (Map.Entry<String, Reading> reading : sample.readings().entrySet()) {
      CrossComException failure = reading.getValue().failure();
      if (failure != null) {
        json.writeStringField(reading.getKey(), failure.getMessage());
      }
    }
    json.writeEndObject();
  }
}
