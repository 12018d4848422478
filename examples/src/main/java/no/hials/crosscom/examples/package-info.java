/**
 * Examples, one class per task. Each takes {@code HOST PORT} as its arguments, and starts the
 * simulated controller without arguments. Examples that load programs or advance the time need the
 * simulation, as their documentation says.
 *
 * <p>The snippets of the documentation are lines of these classes; a test compares them.
 */
@NullMarked
package no.hials.crosscom.examples;

import org.jspecify.annotations.NullMarked;
