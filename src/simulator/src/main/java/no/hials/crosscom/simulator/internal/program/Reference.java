package no.hials.crosscom.simulator.internal.program;

import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.RefusedException;
import no.hials.crosscom.simulator.internal.data.Storage;
import no.hials.crosscom.simulator.internal.data.VariablePath;

/**
 * A variable, or a part of it, that was passed as {@code :OUT}, with the indices at the time of the
 * call.
 *
 * @param location the location of the variable
 * @param frame the frame of that location
 * @param path the part
 */
record Reference(StorageLocation location, CallFrame frame, VariablePath path) {
  /** Returns the reference to the array itself, without {@code []} after its name. */
  Reference whole() {
    return new Reference(location, frame, path.withoutBrackets());
  }

  Storage storage(VariablePath inner) throws RefusedException {
    return location.storage(frame, path.then(inner));
  }

  KrlValue value(VariablePath inner) throws RefusedException {
    return location.value(frame, path.then(inner));
  }

  void store(VariablePath inner, KrlValue value) throws RefusedException {
    location.store(frame, path.then(inner), value);
  }

  String name(VariablePath inner) {
    return location.name(frame, path.then(inner));
  }

  KrlValue read() throws KrlExecutionException {
    return location.read(frame, path);
  }

  void write(KrlValue value) throws KrlExecutionException {
    location.write(frame, path, value);
  }
}
