package no.hials.crosscom.simulator.internal.program;

import java.util.List;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.simulator.internal.data.Storage;
import no.hials.crosscom.simulator.internal.data.VariablePath;
import org.jspecify.annotations.Nullable;

/**
 * A routine in the form that the machine executes. Calls of it are compiled before its body, which
 * is added later.
 */
final class CompiledRoutine {
  private final String module;
  private final String name;
  private final boolean function;
  private final List<Parameter> parameters;
  private @Nullable Body body;

  /**
   * A parameter.
   *
   * @param path its name as a path
   * @param array whether it is an array
   * @param out whether it is passed by reference
   */
  record Parameter(VariablePath path, boolean array, boolean out) {}

  /**
   * The body of a routine.
   *
   * @param code its instructions
   * @param locals its variables without values, the parameters first; a parameter by reference uses
   *     its own if the argument is omitted
   * @param result a variable of the type of a function's value; null for a subprogram
   * @param temporaries the number of values that loops and branches keep
   */
  record Body(CompiledCode code, List<Storage> locals, @Nullable Storage result, int temporaries) {}

  CompiledRoutine(String module, String name, boolean function, List<Parameter> parameters) {
    this.module = module;
    this.name = name;
    this.function = function;
    this.parameters = List.copyOf(parameters);
  }

  String module() {
    return module;
  }

  String name() {
    return name;
  }

  boolean isFunction() {
    return function;
  }

  List<Parameter> parameters() {
    return parameters;
  }

  void complete(Body newBody) {
    body = newBody;
  }

  Body body() {
    if (body == null) {
      throw new IllegalStateException(name + " has errors and cannot be executed");
    }
    return body;
  }

  /** Returns the position of the first statement. */
  Position begin() {
    return body().code().position(0);
  }
}
