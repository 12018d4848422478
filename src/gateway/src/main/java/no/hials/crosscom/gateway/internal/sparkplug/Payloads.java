package no.hials.crosscom.gateway.internal.sparkplug;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.time.Instant;
import java.util.Collection;
import java.util.Date;
import java.util.List;
import org.eclipse.tahu.SparkplugInvalidTypeException;
import org.eclipse.tahu.message.SparkplugBPayloadDecoder;
import org.eclipse.tahu.message.SparkplugBPayloadEncoder;
import org.eclipse.tahu.message.model.Metric;
import org.eclipse.tahu.message.model.SparkplugBPayload;
import org.jspecify.annotations.Nullable;

/** Encodes and decodes the payloads of Sparkplug B. */
final class Payloads {
  private Payloads() {}

  /**
   * Encodes metrics.
   *
   * @param seq the sequence number; null for a payload without one
   */
  static byte[] encode(@Nullable Integer seq, Collection<Metric> metrics) {
    SparkplugBPayload.SparkplugBPayloadBuilder builder =
        new SparkplugBPayload.SparkplugBPayloadBuilder()
            .setTimestamp(Date.from(Instant.now()))
            .addMetrics(metrics);
    if (seq != null) {
      builder = builder.setSeq(seq.longValue());
    }
    try {
      return new SparkplugBPayloadEncoder().getBytes(builder.createPayload(), false);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Decodes metrics.
   *
   * @throws IllegalArgumentException if the bytes are not a payload
   */
  static List<Metric> decode(ByteBuffer payload) {
    byte[] bytes = new byte[payload.remaining()];
    payload.duplicate().get(bytes);
    try {
      return new SparkplugBPayloadDecoder().buildFromByteArray(bytes, null).getMetrics();
    } catch (Exception e) {
      throw new IllegalArgumentException("not a payload of Sparkplug B: " + e.getMessage(), e);
    }
  }

  /** Creates a metric. */
  static Metric metric(Metric.MetricBuilder builder) {
    try {
      return builder.createMetric();
    } catch (SparkplugInvalidTypeException e) {
      throw new IllegalArgumentException(e);
    }
  }
}
