package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.Map;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.data.Operators;

/**
 * The assignments of a program that are evaluated again in each of its cycles: cyclic flags, ANIN
 * and ANOUT (docs/reference/krl-language.md#analogue-cycles). Assumed: not while the program is
 * stopped.
 */
final class CyclicAssignments {
  /** docs/reference/system-variables.md#inputs-outputs-and-timers. */
  private static final int MAX_ACTIVE = 64;

  /** The longest delay in s, so that the values that wait cannot fill the memory (assumed). */
  private static final double MAX_DELAY = 60;

  /** By the path of the target, as printed. */
  private final Map<String, Active> active = new LinkedHashMap<>();

  /**
   * The limits and the delay of the values.
   *
   * @param delay in s
   */
  record Shape(double delay, double minimum, double maximum) {
    static final Shape NONE = new Shape(0, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

    KrlValue limit(KrlValue value) throws KrlExecutionException {
      if (this.equals(NONE)) {
        return value;
      }
      double number = Operators.number(value);
      return number >= minimum && number <= maximum
          ? value
          : KrlReal.of(Math.max(minimum, Math.min(maximum, number)));
    }
  }

  private record Due(long time, KrlValue value) {}

  private record Active(Reference target, CompiledCode value, Shape shape, Deque<Due> delayed) {}

  void clear() {
    active.clear();
  }

  /** Starts an assignment, which replaces an earlier one to the same target, and executes it. */
  void start(Reference target, CompiledCode value, Shape shape, KrlVirtualMachine machine)
      throws KrlExecutionException {
    String key = target.path().toString();
    if (shape.delay() > MAX_DELAY) {
      throw new KrlExecutionException(
          KrlExecutionException.OUT_OF_RANGE,
          "a DELAY of ANOUT is at most " + MAX_DELAY + " s, was given " + shape.delay());
    }
    if (!active.containsKey(key) && active.size() >= MAX_ACTIVE) {
      throw new KrlExecutionException(
          KrlExecutionException.CYCLIC_FLAG,
          "at most "
              + MAX_ACTIVE
              + " assignments are evaluated in cycles, "
              + key
              + " is one more");
    }
    Active started = new Active(target, value, shape, new ArrayDeque<>());
    execute(started, machine);
    active.put(key, started);
  }

  void end(Reference target) {
    active.remove(target.path().toString());
  }

  void execute(KrlVirtualMachine machine) throws KrlExecutionException {
    for (Active each : active.values()) {
      execute(each, machine);
    }
  }

  private static void execute(Active each, KrlVirtualMachine machine) throws KrlExecutionException {
    KrlValue value = each.shape().limit(machine.value(each.value(), each.target().frame()));
    if (each.shape().delay() <= 0) {
      each.target().write(value);
      return;
    }
    each.delayed().add(new Due(machine.environment().timeAfter(each.shape().delay()), value));
    long now = machine.environment().time();
    while (!each.delayed().isEmpty() && each.delayed().element().time() <= now) {
      each.target().write(each.delayed().remove().value());
    }
  }
}
