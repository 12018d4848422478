package no.hials.crosscom.gateway.internal.mqtt;

import no.hials.crosscom.gateway.internal.broker.BrokerSettings;
import no.hials.crosscom.gateway.internal.sparkplug.SparkplugId;
import org.jspecify.annotations.Nullable;

/**
 * The table {@code mqtt}.
 *
 * @param topic the first part of all topics
 * @param qos the quality of service of values, 0 to 2
 * @param commands whether commands are executed
 * @param sparkplug the name for Sparkplug; null to publish plain topics only
 */
record MqttSettings(
    BrokerSettings broker,
    String topic,
    int qos,
    boolean commands,
    @Nullable SparkplugId sparkplug) {}
