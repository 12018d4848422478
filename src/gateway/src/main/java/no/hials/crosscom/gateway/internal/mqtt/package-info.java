/** The values of robots as retained JSON messages, a topic for each variable. */
@NullMarked
package no.hials.crosscom.gateway.internal.mqtt;

import org.jspecify.annotations.NullMarked;
