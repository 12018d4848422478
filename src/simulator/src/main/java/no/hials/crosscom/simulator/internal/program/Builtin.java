package no.hials.crosscom.simulator.internal.program;

import java.util.List;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import org.jspecify.annotations.Nullable;

/**
 * A routine that is built into the controller.
 *
 * @param name in upper case
 * @param function whether it returns a value
 * @param parameters the kinds of its parameters
 * @param optional the number of parameters at the end that can be omitted
 * @param body its code
 */
record Builtin(String name, boolean function, List<Kind> parameters, int optional, Body body) {

  /** The form of an argument. */
  enum Kind {
    /** A {@link KrlValue}. */
    VALUE,
    /** The {@link KrlValue} of a text literal, or the {@link Reference} to a CHAR array. */
    TEXT,
    /** A {@link Reference}. */
    OUT
  }

  /** The code of a built-in routine. */
  @FunctionalInterface
  interface Body {
    /**
     * Executes the routine.
     *
     * @param symbols the variables of the calling routine
     * @param arguments one for each parameter; null for an omitted argument
     * @return the value of a function
     */
    @Nullable KrlValue call(
        KrlVirtualMachine machine, SymbolTable symbols, @Nullable Object[] arguments)
        throws KrlExecutionException;
  }
}
