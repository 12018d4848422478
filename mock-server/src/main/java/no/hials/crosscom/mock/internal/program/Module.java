package no.hials.crosscom.mock.internal.program;

import java.util.List;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.SourceFile;
import no.hials.crosscom.mock.internal.data.Scope;

/**
 * A module of the library.
 *
 * @param source its routines
 * @param scope the variables of its data list
 * @param dataErrors what is wrong in the data list
 */
record Module(SourceFile source, Scope scope, List<KrlError> dataErrors) {
  String name() {
    return source.name();
  }
}
