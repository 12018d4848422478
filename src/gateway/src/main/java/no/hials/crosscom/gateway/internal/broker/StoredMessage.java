package no.hials.crosscom.gateway.internal.broker;

import java.nio.ByteBuffer;
import java.util.zip.CRC32;

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

  /** Returns a name that tells it from other messages of its topic, for the log. */
  String name() {
    CRC32 crc = new CRC32();
    crc.update(payload.duplicate());
    return "a stored message of " + topic + " (" + Long.toHexString(crc.getValue()) + ")";
  }
}
