/** Measures how long accesses take. */
@NullMarked
package no.hials.crosscom.lab.bench;

import org.jspecify.annotations.NullMarked;
