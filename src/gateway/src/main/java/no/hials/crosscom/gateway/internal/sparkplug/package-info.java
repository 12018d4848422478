/** The values of robots as Sparkplug B: the gateway is an edge node, and each robot a device. */
@NullMarked
package no.hials.crosscom.gateway.internal.sparkplug;

import org.jspecify.annotations.NullMarked;
