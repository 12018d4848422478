/** Tests of the connectors without a broker. */
@NullMarked
package no.hials.crosscom.kafka;

import org.jspecify.annotations.NullMarked;
