/**
 * The messages that read and write variables: one as text, an array as 16-bit numbers, several at
 * once, and the benchmark of such accesses.
 *
 * <p>KUKAVARPROXY knows the four oldest; C3 Bridge knows the others and the text messages.
 */
@NullMarked
package no.hials.crosscom.protocol.variable;

import org.jspecify.annotations.NullMarked;
