package no.hials.crosscom.gateway.internal.broker;

import java.nio.ByteBuffer;

/**
 * A message that is kept until a broker has it.
 *
 * @param topic its topic, or another name of its destination
 */
public record StoredMessage(String topic, ByteBuffer payload) {
  /** Creates a message. */
  public StoredMessage(String topic, byte[] payload) {
    this(topic, ByteBuffer.wrap(payload).asReadOnlyBuffer());
  }
}
