/**
 * The values of robots as retained JSON messages, a topic for each variable. The names of topics
 * and the JSON are here; the connection and the store are in the package of the broker.
 */
@NullMarked
package no.hials.crosscom.gateway.internal.mqtt;

import org.jspecify.annotations.NullMarked;
