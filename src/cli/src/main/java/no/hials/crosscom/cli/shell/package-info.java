/** The interactive shell and its scripts. */
@NullMarked
package no.hials.crosscom.cli.shell;

import org.jspecify.annotations.NullMarked;
