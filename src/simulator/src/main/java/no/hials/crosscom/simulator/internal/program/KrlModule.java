package no.hials.crosscom.simulator.internal.program;

import no.hials.crosscom.lang.SourceFile;
import no.hials.crosscom.simulator.LoadingMode;
import no.hials.crosscom.simulator.internal.data.Scope;

/**
 * A module of the library.
 *
 * @param source its routines
 * @param data its data list
 * @param mode whether it can be selected with errors; the program stops where it reaches one
 */
record KrlModule(SourceFile source, ModuleData data, LoadingMode mode) {
  String name() {
    return source.name();
  }

  /** Returns the variables of its data list. */
  Scope scope() {
    return data.scope();
  }
}
