/**
 * Types, variables and their values, as a controller keeps them: for the table that clients see,
 * for data lists and for programs. Values are checked against types when they are written.
 */
@NullMarked
package no.hials.crosscom.simulator.internal.data;

import org.jspecify.annotations.NullMarked;
