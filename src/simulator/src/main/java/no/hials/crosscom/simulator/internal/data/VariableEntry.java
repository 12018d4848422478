package no.hials.crosscom.simulator.internal.data;

import java.util.function.Supplier;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;

/**
 * A variable or signal of a scope. Immutable; a write replaces it.
 *
 * @param name as declared, without dimensions
 * @param access what clients and programs may do
 * @param contents the value; null for a SIGNAL
 * @param signal the wiring of a SIGNAL, else null
 * @param source returns the value at each read; null if the contents are the value
 */
record VariableEntry(
    String name,
    Access access,
    @Nullable Storage contents,
    @Nullable SignalWiring signal,
    @Nullable Supplier<KrlValue> source) {

  static VariableEntry variable(String name, Access access, Storage contents) {
    return new VariableEntry(name, access, contents, null, null);
  }

  static VariableEntry signal(String name, Access access, SignalWiring wiring) {
    return new VariableEntry(name, access, null, wiring, null);
  }

  /** Returns the bytes of the name and the contents, about. */
  long bytes() {
    return Scope.NAME_BYTES + (contents == null ? 0 : contents.bytes());
  }

  VariableEntry with(Storage newContents) {
    return new VariableEntry(name, access, newContents, null, source);
  }

  VariableEntry bound(@Nullable Supplier<KrlValue> newSource) {
    return new VariableEntry(name, access, contents, signal, newSource);
  }

  /** Returns the wiring of a SIGNAL, which a path must name as a whole. */
  SignalWiring wiring(VariablePath path) throws RefusedException {
    if (signal == null) {
      throw new IllegalStateException(name + " has neither contents nor wiring");
    }
    if (!path.first().index().isNone()) {
      throw Storage.badIndex("a SIGNAL is not an array");
    }
    if (!path.isLast(0)) {
      throw new RefusedException(Refusal.UNKNOWN_COMPONENT, "a SIGNAL has no components");
    }
    return signal;
  }

  /** Returns the current contents; null for a SIGNAL. */
  @Nullable Storage current() throws RefusedException {
    return contents == null || source == null ? contents : contents.assign(source.get());
  }
}
