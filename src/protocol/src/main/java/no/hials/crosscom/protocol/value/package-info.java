/**
 * KRL values as a controller prints and accepts them: one sealed type, one parser, one printer.
 *
 * <p>{@link no.hials.crosscom.protocol.value.KrlScanner} is the only code that reads KRL text; the
 * value tree and the client's typed variables are both built on it, so they cannot disagree.
 */
@NullMarked
package no.hials.crosscom.protocol.value;

import org.jspecify.annotations.NullMarked;
