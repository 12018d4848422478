/**
 * Tests against Mosquitto, Prometheus and the Python client asyncua: {@code mvn -Pplant verify}.
 */
@NullMarked
package no.hials.crosscom.gateway.broker;

import org.jspecify.annotations.NullMarked;
