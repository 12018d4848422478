/** Tests with a broker and workers of Kafka Connect, each a process of its own. */
@NullMarked
package no.hials.crosscom.kafka.cluster;

import org.jspecify.annotations.NullMarked;
