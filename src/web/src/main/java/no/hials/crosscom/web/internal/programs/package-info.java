/** Runs programs, shows messages, inputs and outputs, and finds out why a robot stands still. */
@NullMarked
package no.hials.crosscom.web.internal.programs;

import org.jspecify.annotations.NullMarked;
