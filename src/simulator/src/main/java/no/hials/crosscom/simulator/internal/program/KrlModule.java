package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.Declaration;
import no.hials.crosscom.lang.SourceFile;
import no.hials.crosscom.simulator.LoadingMode;
import no.hials.crosscom.simulator.internal.data.Import;
import no.hials.crosscom.simulator.internal.data.KrlErrorException;
import no.hials.crosscom.simulator.internal.data.Scope;
import org.jspecify.annotations.Nullable;

/**
 * A module of the library.
 *
 * @param source its routines
 * @param data its data list
 * @param mode whether it can be selected with errors; the program stops where it reaches one
 */
record KrlModule(SourceFile source, Data data, LoadingMode mode) {
  String name() {
    return source.name();
  }

  /** Returns the variables of its data list. */
  Scope scope() {
    return data.scope();
  }

  /**
   * The variables of a data list. The list of a module without routines has them, too.
   *
   * @param scope the variables that it declares
   * @param isPublic whether other modules can import them
   * @param imports what it imports from other modules
   */
  record Data(Scope scope, boolean isPublic, List<Import> imports) {
    /** Returns the data of a module; without a list, it has no variables. */
    static Data of(@Nullable DataList list, Scope scope) {
      return list == null
          ? new Data(scope, false, List.of())
          : new Data(scope, list.isPublic(), imports(list));
    }

    private static List<Import> imports(DataList list) {
      List<Import> imports = new ArrayList<>();
      for (Declaration declaration : list.declarations()) {
        if (declaration instanceof Declaration.External external) {
          try {
            Import.of(external).ifPresent(imports::add);
          } catch (KrlErrorException e) {
            // an error of the data list, which was reported when it was loaded
          }
        }
      }
      return List.copyOf(imports);
    }
  }
}
