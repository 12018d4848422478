/** Tests with a broker and workers of Kafka Connect, each in its own process. */
@NullMarked
package no.hials.crosscom.kafka.cluster;

import org.jspecify.annotations.NullMarked;
