package no.hials.crosscom.gateway.internal.broker;

import java.nio.ByteBuffer;
import java.time.Duration;
import org.jspecify.annotations.Nullable;

/**
 * A message from a broker.
 *
 * @param retained whether the broker marked it as retained, so that its age is unknown
 * @param sender the name that the client claims; empty without one
 * @param responseTopic the topic for the answer, with MQTT 5 only
 * @param correlation the data that the answer repeats, with MQTT 5 only
 * @param expiry what remains of its time, with MQTT 5 only; null if it does not expire
 */
public record Received(
    String topic,
    ByteBuffer payload,
    boolean retained,
    String sender,
    @Nullable String responseTopic,
    @Nullable ByteBuffer correlation,
    @Nullable Duration expiry) {}
