package no.hials.crosscom.gateway.internal.broker;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.nio.ByteBuffer;
import org.jspecify.annotations.Nullable;

/**
 * A message to a broker.
 *
 * @param qos the quality of service, 0 to 2
 * @param retained whether the broker keeps it for later subscribers
 * @param correlation the data that an answer repeats, with MQTT 5 only; null for none
 */
public record Publication(
    String topic, ByteBuffer payload, int qos, boolean retained, @Nullable ByteBuffer correlation) {

  /** Creates a message that is not an answer. */
  public Publication(String topic, byte[] payload, int qos, boolean retained) {
    this(topic, ByteBuffer.wrap(payload).asReadOnlyBuffer(), qos, retained, null);
  }

  /** Returns the maximum size of the packet in bytes. */
  int size() {
    int header = 5; // kind, and the length of the rest
    int properties = 4 + (correlation == null ? 0 : 3 + correlation.remaining());
    return header
        + 2
        + topic.getBytes(UTF_8).length
        + (qos == 0 ? 0 : 2)
        + properties
        + payload.remaining();
  }
}
