/** The gateway: reads robots and passes their values on to the systems of a plant. */
@NullMarked
package no.hials.crosscom.gateway;

import org.jspecify.annotations.NullMarked;
