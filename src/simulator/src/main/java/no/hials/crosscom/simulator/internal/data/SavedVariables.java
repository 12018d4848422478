package no.hials.crosscom.simulator.internal.data;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/** Variables of a scope as they were before data lists changed them. Thread-safe. */
public final class SavedVariables {
  /** The variables by their keys, empty for those that did not exist. */
  private final Map<String, Optional<VariableEntry>> entries = new HashMap<>();

  /** Keeps variables as they are now, unless they are kept already. */
  public synchronized void keep(Scope scope, Set<String> names) {
    for (String name : names) {
      entries.computeIfAbsent(name, key -> Optional.ofNullable(scope.lookup(key)));
    }
  }

  /** Adds the variables that another object keeps. */
  public void copyFrom(SavedVariables other) {
    Map<String, Optional<VariableEntry>> copy;
    synchronized (other) {
      copy = Map.copyOf(other.entries);
    }
    synchronized (this) {
      entries.putAll(copy);
    }
  }

  /** Restores those of some variables that are kept, and keeps them no longer. */
  public synchronized void restore(Scope scope, Set<String> names) {
    for (String name : names) {
      Optional<VariableEntry> old = entries.remove(name);
      if (old == null) {
        continue;
      }
      @Nullable VariableEntry now = scope.lookup(name);
      if (old.isPresent()) {
        scope.put(old.get().bound(now == null ? null : now.source()));
      } else {
        scope.remove(name);
      }
    }
  }

  /** Keeps nothing any longer. */
  public synchronized void forget() {
    entries.clear();
  }
}
