/**
 * An OPC UA server with the values of robots. The server keeps each reading as it is, and converts
 * a value only when a client reads or watches its node.
 */
@NullMarked
package no.hials.crosscom.gateway.internal.opcua;

import org.jspecify.annotations.NullMarked;
