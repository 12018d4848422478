/**
 * Typed variables: local copies that {@link no.hials.crosscom.CrossComClient} reads and writes.
 *
 * <p>The classes have the names of the original JOpenShowVar. A variable is not thread-safe. Only
 * its setters, a read and a successful write change its value.
 */
@NullMarked
package no.hials.crosscom.KRL;

import org.jspecify.annotations.NullMarked;
