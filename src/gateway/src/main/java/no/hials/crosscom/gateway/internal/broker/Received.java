package no.hials.crosscom.gateway.internal.broker;

import java.nio.ByteBuffer;
import org.jspecify.annotations.Nullable;

/**
 * A message from a broker.
 *
 * @param retained whether the broker has kept it, so that nobody knows how old it is
 * @param sender the name that the client gives itself; empty if it has none
 * @param responseTopic where it wants the answer, with MQTT 5 only
 * @param correlation the data that the answer repeats, with MQTT 5 only
 */
public record Received(
    String topic,
    ByteBuffer payload,
    boolean retained,
    String sender,
    @Nullable String responseTopic,
    @Nullable ByteBuffer correlation) {}
