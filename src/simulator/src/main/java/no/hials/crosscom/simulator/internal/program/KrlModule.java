package no.hials.crosscom.simulator.internal.program;

import no.hials.crosscom.lang.SourceFile;
import no.hials.crosscom.simulator.internal.data.Scope;

/**
 * A module of the library.
 *
 * @param source its routines
 * @param scope the variables of its data list
 */
record KrlModule(SourceFile source, Scope scope) {
  String name() {
    return source.name();
  }
}
