package no.hials.crosscom.mock;

import org.jspecify.annotations.Nullable;

/**
 * An entry of the table. Immutable; a write puts a new one in its place.
 *
 * @param name as declared, without dimensions
 * @param access what clients may do
 * @param contents the value; null for a SIGNAL
 * @param signal the wiring of a SIGNAL, else null
 */
record Variable(String name, Access access, @Nullable Node contents, @Nullable Signal signal) {

  Variable with(Node newContents) {
    return new Variable(name, access, newContents, null);
  }
}
