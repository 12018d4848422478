/**
 * The command {@code krl}: checks and runs KRL files on a simulated controller without a network.
 * Its commands load files as {@code mock} does.
 */
@NullMarked
package no.hials.crosscom.cli.krl;

import org.jspecify.annotations.NullMarked;
