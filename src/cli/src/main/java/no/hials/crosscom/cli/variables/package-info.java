/** Commands that read, write, watch and record variables. */
@NullMarked
package no.hials.crosscom.cli.variables;

import org.jspecify.annotations.NullMarked;
