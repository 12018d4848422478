package no.hials.crosscom.simulator.internal.program;

import java.util.List;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import org.jspecify.annotations.Nullable;

/**
 * A routine that the controller itself has.
 *
 * @param name its name in upper case
 * @param function whether it has a value
 * @param parameters what it takes
 * @param optional how many of the last parameters may be left out
 * @param body what it does
 */
record Builtin(String name, boolean function, List<Kind> parameters, int optional, Body body) {

  /** What an argument is handed over as. */
  enum Kind {
    /** A {@link KrlValue}. */
    VALUE,
    /** The {@link KrlValue} of a text literal, or the {@link Reference} to a CHAR array. */
    TEXT,
    /** A {@link Reference}. */
    OUT
  }

  /** What a built-in routine does. */
  @FunctionalInterface
  interface Body {
    /**
     * Executes it.
     *
     * @param symbols what the calling routine can name
     * @param arguments one for each parameter; null for one that is left out
     * @return the value of a function
     */
    @Nullable KrlValue call(
        KrlVirtualMachine machine, SymbolTable symbols, @Nullable Object[] arguments)
        throws KrlExecutionException;
  }
}
