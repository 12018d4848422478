/** Code that the packages of the simulated controller and the mock server share. */
@NullMarked
package no.hials.crosscom.simulator.internal;

import org.jspecify.annotations.NullMarked;
