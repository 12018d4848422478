/**
 * Connectors of Kafka Connect: values of robots into topics, and allowed writes from topics. The
 * robots are spread over tasks; a task uses its robots only while it holds a lease that the broker
 * has confirmed.
 */
@NullMarked
package no.hials.crosscom.kafka;

import org.jspecify.annotations.NullMarked;
