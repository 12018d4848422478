/**
 * KRL programs: a library of modules, a compiler from their trees to flat code, and the machine
 * that executes it. The machine can pause between any two instructions, keeps its own call stack,
 * starts no thread, and uses the controller only through {@link
 * no.hials.crosscom.simulator.internal.program.ProgramEnvironment}.
 */
@NullMarked
package no.hials.crosscom.simulator.internal.program;

import org.jspecify.annotations.NullMarked;
