package no.hials.crosscom.web.internal.robot;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import no.hials.crosscom.cell.JsonLine;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * The values that were read at one time. Viewers of the same variables share one object and its
 * JSON.
 */
public final class Readings {
  private final Instant time;
  private final Duration access;
  private final Map<String, ReadOutcome> values;
  private @Nullable String json;

  /**
   * The result of reading one variable.
   *
   * @param value the value; null after an error
   * @param error why there is no value; empty if there is one
   * @param missed whether the whole reading failed, as without a connection
   */
  public record ReadOutcome(@Nullable KrlValue value, String error, boolean missed) {}

  Readings(Instant time, Duration access, Map<String, ReadOutcome> values) {
    this.time = time;
    this.access = access;
    this.values = values;
  }

  /** Returns when the reading began. */
  public Instant time() {
    return time;
  }

  /** Returns how long the reading took. */
  public Duration access() {
    return access;
  }

  /** Returns the results by the names of the variables, in capitals. */
  public Map<String, ReadOutcome> values() {
    return values;
  }

  /** Returns whether the whole reading failed, as without a connection. */
  public boolean isMissed() {
    return values.values().stream().allMatch(ReadOutcome::missed);
  }

  /**
   * Returns the fields {@code time} in ms since 1970, {@code access_ms}, {@code missed} and {@code
   * values}, without the braces around them. A value is an object with {@code type} and {@code
   * value} as {@code read --json} prints them, or with {@code error}.
   */
  synchronized String json() {
    if (json == null) {
      String object = JsonLine.object(this::write);
      json = object.substring(1, object.length() - 1);
    }
    return json;
  }

  private void write(JsonGenerator out) throws IOException {
    out.writeNumberField("time", millis(time));
    out.writeNumberField("access_ms", millis(access));
    out.writeBooleanField("missed", isMissed());
    out.writeObjectFieldStart("values");
    for (Map.Entry<String, ReadOutcome> entry : values.entrySet()) {
      KrlValue value = entry.getValue().value();
      out.writeObjectFieldStart(entry.getKey());
      if (value == null) {
        out.writeStringField("error", entry.getValue().error());
      } else {
        JsonLine.writeTyped(out, entry.getKey(), value);
      }
      out.writeEndObject();
    }
    out.writeEndObject();
  }

  /** Returns a time in ms since 1970, with fractions. */
  static double millis(Instant time) {
    return millis(Duration.between(Instant.EPOCH, time));
  }

  /** Returns a duration in ms, rounded to µs. */
  static double millis(Duration duration) {
    return Math.round(duration.getSeconds() * 1e6 + duration.getNano() / 1e3) / 1e3;
  }
}
