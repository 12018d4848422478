/**
 * The messages that read and write variables: a single variable as text, an array as 16-bit
 * numbers, several at once, and the benchmark of such accesses.
 *
 * <p>KUKAVARPROXY supports types 0 to 3 (docs/reference/wire-format.md); C3 Bridge supports all but
 * 2 and 3 (docs/reference/c3-messages.md).
 */
@NullMarked
package no.hials.crosscom.protocol.variable;

import org.jspecify.annotations.NullMarked;
