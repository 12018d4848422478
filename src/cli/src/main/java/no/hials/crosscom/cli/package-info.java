/**
 * The command line: a thin shell around the client, one class a command.
 *
 * <p>Data goes to stdout, everything else to stderr; the exit code is an {@link
 * no.hials.crosscom.cli.base.ExitCode}. {@link no.hials.crosscom.cli.Main} puts the commands
 * together; the streams are handed down to them in a {@link no.hials.crosscom.cli.base.Console}.
 */
@NullMarked
package no.hials.crosscom.cli;

import org.jspecify.annotations.NullMarked;
