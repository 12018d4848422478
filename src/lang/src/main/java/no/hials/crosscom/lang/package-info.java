/**
 * The language KRL: parses {@code .src}, {@code .sub} and {@code .dat} files into trees of records.
 *
 * <p>The parser checks syntax only; the user of a tree resolves its names. Each line is parsed
 * alone and then added to its block, so an error affects only its line; the line stays in the tree
 * as {@link no.hials.crosscom.lang.Statement.Invalid}, and is never skipped. Errors that follow
 * from a reported error are not reported.
 *
 * <p>The statements and declarations of a tree are stored as bytes and created when they are read:
 * equal, but not the same object each time. A tree takes two to five times the memory of its file.
 *
 * <p>The precedence of the operators, highest first: {@code NOT B_NOT} and signs; {@code :}; {@code
 * * /}; {@code + -}; {@code B_AND}; {@code B_EXOR}; {@code B_OR}; the comparisons; {@code AND};
 * {@code EXOR}; {@code OR}. Operators of the same precedence associate to the left. The grammar
 * explains why comparisons are assumed to bind tighter than {@code AND}.
 */
@NullMarked
package no.hials.crosscom.lang;

import org.jspecify.annotations.NullMarked;
