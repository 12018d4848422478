/** Tests of the MQTT output against Mosquitto: {@code mvn -Pplant verify}. */
@NullMarked
package no.hials.crosscom.gateway.broker;

import org.jspecify.annotations.NullMarked;
