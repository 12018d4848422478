package no.hials.crosscom.simulator.internal.core;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.RefusedException;
import no.hials.crosscom.simulator.internal.data.SavedVariables;
import no.hials.crosscom.simulator.internal.data.Scope;
import no.hials.crosscom.simulator.internal.data.Storage;
import no.hials.crosscom.simulator.internal.data.VariablePath;
import no.hials.crosscom.simulator.internal.motion.Joints;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reads and writes the variables that the simulation itself works with. A user may have removed or
 * redeclared any of them; then a default replaces it.
 */
final class SystemVariableAccess {
  private static final Logger LOG = LoggerFactory.getLogger(SystemVariableAccess.class);

  private final Scope globals;

  /** The paths of the names that were read. */
  private final Map<String, VariablePath> paths = new ConcurrentHashMap<>();

  SystemVariableAccess(Scope globals) {
    this.globals = globals;
  }

  private VariablePath path(String name) throws RefusedException {
    VariablePath known = paths.get(name);
    return known == null ? VariablePath.parse(name) : known;
  }

  private @Nullable KrlValue read(String name) {
    try {
      VariablePath path = path(name);
      paths.putIfAbsent(name, path);
      return globals.read(path);
    } catch (RefusedException e) {
      return null;
    }
  }

  /**
   * Returns the contents of a variable, a new object after each write; null if it does not exist.
   */
  @Nullable Storage contents(String name) {
    try {
      return globals.contents(name);
    } catch (RefusedException e) {
      return null;
    }
  }

  /** Returns the value of a variable; empty if it does not exist or has no value. */
  Optional<KrlValue> value(String name) {
    return Optional.ofNullable(read(name));
  }

  double number(String name, double otherwise) {
    KrlValue value = read(name);
    try {
      return value == null ? otherwise : PositionValues.number(value);
    } catch (IllegalArgumentException e) {
      return otherwise;
    }
  }

  boolean bool(String name, boolean otherwise) {
    return read(name) instanceof KrlBool value ? value.value() : otherwise;
  }

  String constant(String name, String otherwise) {
    return read(name) instanceof KrlEnum value ? value.name() : otherwise;
  }

  Frame frame(String name) {
    return read(name) instanceof KrlStruct struct
        ? PositionValues.toFrame(struct, Frame.IDENTITY)
        : Frame.IDENTITY;
  }

  /** Reads the first six elements of an array. */
  Axis axes(String array, double otherwise) {
    double[] numbers = new double[PositionValues.ROBOT_AXES];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = number(array + "[" + (i + 1) + "]", otherwise);
    }
    return Axis.of(numbers);
  }

  /** Reads the aggregate of an axis position. */
  Axis position(String name, Axis otherwise) {
    return read(name) instanceof KrlStruct struct
        ? PositionValues.toAxes(struct, otherwise)
        : otherwise;
  }

  /** Reads the aggregate of an axis position with external axes, which are 0 if missing. */
  Joints joints(String name, Axis otherwise) {
    Axis external =
        read(name) instanceof KrlStruct struct
            ? PositionValues.toExternal(struct, Axis.ZERO)
            : Axis.ZERO;
    return new Joints(position(name, otherwise), external);
  }

  /** Restores variables as they were before data lists changed them. */
  void restore(SavedVariables before, Set<String> names) {
    before.restore(globals, names);
  }

  /** Writes a value, and returns whether that was possible. */
  boolean write(String name, KrlValue value) {
    try {
      globals.write(path(name), value, Scope.Writer.SYSTEM);
      return true;
    } catch (RefusedException e) {
      LOG.trace("{} cannot be set: {}", name, e.getMessage());
      return false;
    }
  }
}
