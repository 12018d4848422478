/**
 * The gateway: reads robots and passes their values on to the systems of a plant. Each robot has
 * one connection, whatever the number of outputs; an output neither delays nor ends a reading.
 */
@NullMarked
package no.hials.crosscom.gateway;

import org.jspecify.annotations.NullMarked;
