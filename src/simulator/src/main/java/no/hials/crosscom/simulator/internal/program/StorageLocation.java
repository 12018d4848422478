package no.hials.crosscom.simulator.internal.program;

import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.RefusedException;
import no.hials.crosscom.simulator.internal.data.Scope;
import no.hials.crosscom.simulator.internal.data.Storage;
import no.hials.crosscom.simulator.internal.data.VariablePath;

/**
 * The location of a variable of a routine. The compiler finds it once; the path to a part can
 * differ each time.
 */
sealed interface StorageLocation {

  /** Returns a part of the variable, with or without a value. */
  Storage storage(CallFrame frame, VariablePath path) throws RefusedException;

  default KrlValue value(CallFrame frame, VariablePath path) throws RefusedException {
    return storage(frame, path).value();
  }

  void store(CallFrame frame, VariablePath path, KrlValue value) throws RefusedException;

  /** Returns the path of the variable at its location, for messages. */
  default String name(CallFrame frame, VariablePath path) {
    return path.toString();
  }

  /** Returns a value, which must exist. */
  default KrlValue read(CallFrame frame, VariablePath path) throws KrlExecutionException {
    try {
      KrlValue value = value(frame, path);
      if (value instanceof KrlStruct struct && struct.fields().isEmpty()) {
        throw new KrlExecutionException(
            KrlExecutionException.NOT_INITIALISED, name(frame, path) + ": has no value yet");
      }
      return value;
    } catch (RefusedException e) {
      throw KrlExecutionException.of(name(frame, path), e);
    }
  }

  default void write(CallFrame frame, VariablePath path, KrlValue value)
      throws KrlExecutionException {
    try {
      store(frame, path, value);
    } catch (RefusedException e) {
      throw KrlExecutionException.of(name(frame, path), e);
    }
  }

  /**
   * A variable of the routine, or a parameter by value.
   *
   * @param slot its number in the frame
   */
  record Local(int slot) implements StorageLocation {
    @Override
    public Storage storage(CallFrame frame, VariablePath path) throws RefusedException {
      return frame.local(slot).read(path);
    }

    @Override
    public void store(CallFrame frame, VariablePath path, KrlValue value) throws RefusedException {
      frame.setLocal(slot, frame.local(slot).store(path, value));
    }
  }

  /**
   * A parameter by reference.
   *
   * @param slot its number in the frame
   */
  record Parameter(int slot) implements StorageLocation {
    @Override
    public Storage storage(CallFrame frame, VariablePath path) throws RefusedException {
      return frame.reference(slot).storage(path);
    }

    @Override
    public KrlValue value(CallFrame frame, VariablePath path) throws RefusedException {
      return frame.reference(slot).value(path);
    }

    @Override
    public void store(CallFrame frame, VariablePath path, KrlValue value) throws RefusedException {
      frame.reference(slot).store(path, value);
    }

    @Override
    public String name(CallFrame frame, VariablePath path) {
      return path + " (" + frame.reference(slot).name(path) + ")";
    }
  }

  /**
   * A variable of a module or of the controller.
   *
   * @param scope the scope that declares it
   */
  record Shared(Scope scope) implements StorageLocation {
    @Override
    public Storage storage(CallFrame frame, VariablePath path) throws RefusedException {
      return scope.storage(path);
    }

    @Override
    public KrlValue value(CallFrame frame, VariablePath path) throws RefusedException {
      return scope.read(path);
    }

    @Override
    public void store(CallFrame frame, VariablePath path, KrlValue value) throws RefusedException {
      scope.write(path, value, Scope.Writer.PROGRAM);
    }
  }
}
