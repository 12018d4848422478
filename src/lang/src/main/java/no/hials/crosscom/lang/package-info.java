/**
 * The language KRL: parses {@code .src}, {@code .sub} and {@code .dat} files into trees of records.
 *
 * <p>The grammar knows the form of the language only; what names mean is left to whoever uses the
 * tree. What it does not support is an error at its place, never skipped. A line is parsed on its
 * own and then put into the block that it stands in, so that a mistake stays in its line; what may
 * follow from a mistake that was reported is not reported.
 *
 * <p>The precedence of the operators, the tightest first: {@code NOT B_NOT} and signs; {@code :};
 * {@code * /}; {@code + -}; {@code B_AND}; {@code B_EXOR}; {@code B_OR}; the comparisons; {@code
 * AND}; {@code EXOR}; {@code OR}. Operators of one rank are taken from left to right. That
 * comparisons bind tighter than {@code AND} is assumed; the grammar says why.
 */
@NullMarked
package no.hials.crosscom.lang;

import org.jspecify.annotations.NullMarked;
