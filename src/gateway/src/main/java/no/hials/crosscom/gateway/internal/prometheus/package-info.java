/** The values of robots and the figures of the gateway for Prometheus. */
@NullMarked
package no.hials.crosscom.gateway.internal.prometheus;

import org.jspecify.annotations.NullMarked;
