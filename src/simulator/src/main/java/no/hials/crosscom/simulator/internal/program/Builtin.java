package no.hials.crosscom.simulator.internal.program;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.RefusedException;
import no.hials.crosscom.simulator.internal.data.Operators;
import no.hials.crosscom.simulator.internal.data.Storage;
import no.hials.crosscom.simulator.internal.data.VariablePath;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

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

  private static final Logger LOG = LoggerFactory.getLogger(Builtin.class);

  /**
   * Executes the routine. An error in the routine itself stops the calling program only, because it
   * cannot have damaged the rest of the simulation.
   */
  @Nullable KrlValue run(Call call) throws KrlExecutionException {
    try {
      return body.run(call);
    } catch (RuntimeException e) {
      LOG.error("{} has failed with the arguments {}", name, call.arguments(), e);
      throw new KrlExecutionException(
          KrlExecutionException.SIMULATION_FAILED, name + " has failed: " + e);
    }
  }

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
    @Nullable KrlValue run(Call call) throws KrlExecutionException;
  }

  /**
   * A call of a built-in routine.
   *
   * @param symbols the variables of the calling routine
   * @param arguments one for each parameter; null for an omitted argument
   */
  record Call(KrlVirtualMachine machine, SymbolTable symbols, List<@Nullable Object> arguments) {
    private static final VariablePath WHOLE = VariablePath.of("VALUE");

    KrlValue value(int at) {
      return (KrlValue) Objects.requireNonNull(arguments.get(at));
    }

    double number(int at) throws KrlExecutionException {
      return Operators.number(value(at));
    }

    Reference reference(int at) {
      return (Reference) Objects.requireNonNull(arguments.get(at));
    }

    KrlStruct position(int at) throws KrlExecutionException {
      return Operators.positionOf(value(at));
    }

    private static Storage storage(Reference reference) throws KrlExecutionException {
      try {
        return reference.storage(WHOLE);
      } catch (RefusedException e) {
        throw KrlExecutionException.of(reference.name(WHOLE), e);
      }
    }

    String text(int at) throws KrlExecutionException {
      if (arguments.get(at) instanceof KrlString string) {
        return string.text();
      }
      Reference reference = reference(at);
      Optional<String> characters = storage(reference).characters();
      if (characters.isEmpty()) {
        throw new KrlExecutionException(
            KrlExecutionException.NOT_INITIALISED,
            reference.name(WHOLE) + ": needs a CHAR array with a value");
      }
      return characters.get();
    }

    /** Returns a text, which is empty if the CHAR array has no value. */
    String textOrEmpty(int at) throws KrlExecutionException {
      boolean unset =
          arguments.get(at) instanceof Reference reference
              && storage(reference).capacity() > 0
              && !storage(reference).initialised();
      return unset ? "" : text(at);
    }

    int capacity(int at) throws KrlExecutionException {
      Reference reference = reference(at);
      int capacity = storage(reference).capacity();
      if (capacity == 0) {
        throw new KrlExecutionException(
            KrlExecutionException.WRONG_TYPE, reference.name(WHOLE) + ": needs a CHAR array");
      }
      return capacity;
    }
  }
}
