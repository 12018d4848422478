/**
 * The values of robots and the figures of the gateway for Prometheus. A request from Prometheus
 * gets the last updates, and causes no access to a robot.
 */
@NullMarked
package no.hials.crosscom.gateway.internal.prometheus;

import org.jspecify.annotations.NullMarked;
