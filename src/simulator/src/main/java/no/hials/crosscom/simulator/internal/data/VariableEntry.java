package no.hials.crosscom.simulator.internal.data;

import java.util.function.Supplier;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Access;
import org.jspecify.annotations.Nullable;

/**
 * An entry of a scope. Immutable; a write puts a new one in its place.
 *
 * @param name as declared, without dimensions
 * @param access what clients and programs may do
 * @param contents the value; null for a SIGNAL
 * @param signal the wiring of a SIGNAL, else null
 * @param source gives the value at each read; null if the contents are the value
 */
record VariableEntry(
    String name,
    Access access,
    @Nullable Storage contents,
    @Nullable SignalWiring signal,
    @Nullable Supplier<KrlValue> source) {

  VariableEntry with(Storage newContents) {
    return new VariableEntry(name, access, newContents, null, source);
  }

  VariableEntry bound(@Nullable Supplier<KrlValue> newSource) {
    return new VariableEntry(name, access, contents, signal, newSource);
  }
}
