/** The command that runs a simulated controller. */
@NullMarked
package no.hials.crosscom.cli.mock;

import org.jspecify.annotations.NullMarked;
