/**
 * Connectors of Kafka Connect: one reads robots into topics, the other writes the variables that
 * records name. The robots are spread over tasks. A task uses its robots only while it holds a
 * lease that the broker has confirmed.
 */
@NullMarked
package no.hials.crosscom.kafka;

import org.jspecify.annotations.NullMarked;
