/**
 * An OPC UA server with the values of robots. A reading is kept as it came; a node takes its value
 * from it when somebody reads or has subscribed to it.
 */
@NullMarked
package no.hials.crosscom.gateway.internal.opcua;

import org.jspecify.annotations.NullMarked;
