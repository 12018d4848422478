/** Tests of the nodes of the OPC UA server. */
@NullMarked
package no.hials.crosscom.gateway.internal.opcua;

import org.jspecify.annotations.NullMarked;
