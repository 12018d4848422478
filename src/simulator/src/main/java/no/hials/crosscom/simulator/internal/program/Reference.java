package no.hials.crosscom.simulator.internal.program;

import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.ProgramFault;
import no.hials.crosscom.simulator.RefusedException;
import no.hials.crosscom.simulator.internal.data.Node;
import no.hials.crosscom.simulator.internal.data.Path;

/**
 * A variable, or a part of it, that was handed over as {@code :OUT}. Its indices are those of the
 * moment of the call.
 *
 * @param place where the variable lives
 * @param frame the frame in which that is
 * @param path the part
 */
record Reference(Place place, Frame frame, Path path) {
  Node node(Path inner) throws RefusedException {
    return place.node(frame, path.then(inner));
  }

  KrlValue value(Path inner) throws RefusedException {
    return place.value(frame, path.then(inner));
  }

  void store(Path inner, KrlValue value) throws RefusedException {
    place.store(frame, path.then(inner), value);
  }

  String name(Path inner) {
    return place.name(frame, path.then(inner));
  }

  KrlValue read() throws ProgramFault {
    return place.read(frame, path);
  }

  void write(KrlValue value) throws ProgramFault {
    place.write(frame, path, value);
  }
}
