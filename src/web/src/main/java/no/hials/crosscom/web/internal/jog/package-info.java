/**
 * Moving a robot by hand from the page: one owner at a time, hold to run, and a control loop with
 * all its limits. It is not an enabling device and not an emergency stop.
 */
@NullMarked
package no.hials.crosscom.web.internal.jog;

import org.jspecify.annotations.NullMarked;
