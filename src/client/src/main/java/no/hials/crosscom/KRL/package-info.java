/**
 * Typed variables: local copies that {@link no.hials.crosscom.CrossComClient} reads and writes.
 *
 * <p>The classes and their names are those of the original JOpenShowVar. A variable is for one
 * thread at a time; its value changes only by its setters, a read, or a write that succeeded.
 */
@NullMarked
package no.hials.crosscom.KRL;

import org.jspecify.annotations.NullMarked;
