/** The base of all commands: the console, standard options, exit codes, and the terminal. */
@NullMarked
package no.hials.crosscom.cli.base;

import org.jspecify.annotations.NullMarked;
