/**
 * The parser's own storage: the tree of a file as bytes, and the tokens of a line for ANTLR. It
 * knows the records of a tree, and nothing of how they are built.
 */
@NullMarked
package no.hials.crosscom.lang.internal;

import org.jspecify.annotations.NullMarked;
