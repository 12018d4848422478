/**
 * Examples, one class a task. Each takes {@code HOST PORT} as its arguments, and starts the
 * simulated controller if it gets none. Those that load programs or let the time pass need the
 * simulation, and say so.
 *
 * <p>The snippets of the documentation are lines of these classes; a test compares them.
 */
@NullMarked
package no.hials.crosscom.examples;

import org.jspecify.annotations.NullMarked;
