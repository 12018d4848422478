package no.hials.crosscom;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The results of reading several variables by their handles: for each a value or a failure. They do
 * not change, and any thread can use them.
 *
 * <p>Unless the server reads the variables in one message, they were read one after the other. If
 * {@link CrossComClient#read(Handle...)} reconnects in between, the values before it can be older
 * than a restart of the controller; {@link ConnectionListener} and {@link
 * ClientStatistics#reconnects} show it.
 */
public final class ReadResults {
  /** The results of no handles; nothing is added to it. */
  static final ReadResults NONE = new ReadResults();

  /** A value or an exception for each handle. */
  private final Map<Handle<?>, Object> results = new LinkedHashMap<>();

  ReadResults() {}

  void add(Handle<?> handle, Slot<?> slot, VariableResult result) {
    try {
      result.orThrow();
      add(handle, slot.value());
    } catch (CrossComException e) {
      add(handle, e);
    }
  }

  /** Adds a value of the handle's type or an exception. */
  void add(Handle<?> handle, Object result) {
    results.put(handle, result);
  }

  /**
   * Returns the value of a variable.
   *
   * @param handle one of the handles that were read, or one equal to it
   * @return the value
   * @throws CrossComException if the variable could not be read
   * @throws IllegalArgumentException if the handle was not read
   */
  public <T> T get(Handle<T> handle) throws CrossComException {
    Object result = results.get(handle);
    if (result == null) {
      throw new IllegalArgumentException(
          "the handles that were read are " + results.keySet() + ", not " + handle);
    }
    if (result instanceof CrossComException failure) {
      throw failure;
    }
    return handle.type().cast(result);
  }

  /** Returns the failures, in the order of the handles; empty if all variables were read. */
  public Map<Handle<?>, CrossComException> failures() {
    Map<Handle<?>, CrossComException> failures = new LinkedHashMap<>();
    results.forEach(
        (handle, result) -> {
          if (result instanceof CrossComException failure) {
            failures.put(handle, failure);
          }
        });
    return Collections.unmodifiableMap(failures);
  }

  /** Returns the value or the failure of each handle. */
  @Override
  public String toString() {
    return "ReadResults" + results;
  }
}
