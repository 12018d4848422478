/**
 * The values of robots as Sparkplug B: the gateway is an edge node, and each robot a device. All
 * code runs on the thread of one session, so nothing is locked.
 */
@NullMarked
package no.hials.crosscom.gateway.internal.sparkplug;

import org.jspecify.annotations.NullMarked;
