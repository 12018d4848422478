package no.hials.crosscom.simulator.internal.program;

import java.util.HashMap;
import java.util.Map;
import no.hials.crosscom.simulator.internal.data.Import;
import no.hials.crosscom.simulator.internal.data.KrlErrorException;
import no.hials.crosscom.simulator.internal.data.Scope;
import org.jspecify.annotations.Nullable;

/** The variables that the data list of a module imports; found again for each linking. */
final class Imports {
  private final Map<String, KrlModule.Data> data;
  private final Scope globals;
  private final Map<String, StorageLocation> locations = new HashMap<>();

  /** Why imports have found nothing, by their names in upper case. */
  private final Map<String, String> missing = new HashMap<>();

  /**
   * @param data the data of all modules, by their names in upper case
   * @param globals the variables of the controller
   */
  Imports(Map<String, KrlModule.Data> data, Scope globals) {
    this.data = data;
    this.globals = globals;
  }

  /** Adds the imports of a data list. */
  void add(KrlModule.Data module, LinkErrors errors) {
    for (Import wanted : module.imports()) {
      try {
        locations.put(wanted.name(), resolve(wanted));
      } catch (KrlErrorException e) {
        errors.add(e.error().position(), e.error().message());
        missing.put(wanted.name(), e.error().message());
      }
    }
  }

  /** Returns the location of an imported variable; null without such an import. */
  @Nullable StorageLocation find(String key) {
    return locations.get(key);
  }

  /** Returns why an import has found nothing; null if it has, or without such an import. */
  @Nullable String missing(String key) {
    return missing.get(key);
  }

  /**
   * Returns the location of the variable of another module.
   *
   * @throws KrlErrorException if it does not exist, or the data list is not public
   */
  StorageLocation resolve(Import wanted) throws KrlErrorException {
    KrlModule.Data other = data.get(Scope.key(wanted.module()));
    boolean isDeclared = other != null && other.scope().contains(wanted.name());
    if (other != null && isDeclared && other.isPublic()) {
      return new StorageLocation.Shared(other.scope());
    }
    if (globals.contains(wanted.name())) {
      // the variable is GLOBAL or in a system data list
      return new StorageLocation.Shared(globals);
    }
    // assumed: PUBLIC is what makes a variable available to IMPORT
    throw new KrlErrorException(
        wanted.position(),
        isDeclared
            ? "IMPORT needs a public data list, expected DEFDAT "
                + wanted.module()
                + " PUBLIC, found no PUBLIC"
            : "no module " + wanted.module() + " with a variable " + wanted.name());
  }
}
