/**
 * A connection to an MQTT broker that keeps the messages it cannot deliver: links with MQTT 3.1.1
 * and 5, the store on disk, and the commands that arrive. One thread owns the state of a
 * connection; others give it tasks.
 */
@NullMarked
package no.hials.crosscom.gateway.internal.broker;

import org.jspecify.annotations.NullMarked;
