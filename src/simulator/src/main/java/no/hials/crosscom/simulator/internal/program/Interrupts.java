package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import no.hials.crosscom.lang.Statement.InterruptCommand;
import no.hials.crosscom.simulator.KrlExecutionException;
import org.jspecify.annotations.Nullable;

/** The declared interrupts of a program, and its triggers that are due and have not started. */
final class Interrupts {
  /** Assumed: the system uses 40 to 80 for triggers. */
  private static final int FIRST_OF_SYSTEM = 40;

  private static final int LAST_OF_SYSTEM = 80;
  private static final int LAST = 128;

  /** By priority. A later declaration replaces an earlier one (assumed). */
  private final TreeMap<Integer, Interrupt> declared = new TreeMap<>();

  /** In the order of their occurrence. */
  private final List<Interruption> triggers = new ArrayList<>();

  /** The declaration of an interrupt. */
  record Declaration(int priority, boolean global, CompiledCode condition, CompiledCode action) {}

  /** A declared interrupt. */
  private static final class Interrupt {
    private final Declaration declaration;
    private final CallFrame owner;
    private boolean on;
    private boolean disabled;
    private boolean last;
    private boolean pending;

    Interrupt(Declaration declaration, CallFrame owner) {
      this.declaration = declaration;
      this.owner = owner;
    }
  }

  static void checkPriority(int priority) throws KrlExecutionException {
    if (priority < 1
        || priority > LAST
        || (priority >= FIRST_OF_SYSTEM && priority <= LAST_OF_SYSTEM)) {
      throw new KrlExecutionException(
          KrlExecutionException.OUT_OF_RANGE,
          "the priority of an interrupt is 1 to 39 or 81 to 128, is " + priority);
    }
  }

  void clear() {
    declared.clear();
    triggers.clear();
  }

  void declare(Declaration declaration, CallFrame owner) throws KrlExecutionException {
    checkPriority(declaration.priority());
    declared.put(declaration.priority(), new Interrupt(declaration, owner));
  }

  /** Removes the interrupts that an ending routine has declared, except for GLOBAL ones. */
  void forget(CallFrame owner) {
    if (!declared.isEmpty()) {
      declared
          .values()
          .removeIf(interrupt -> interrupt.owner == owner && !interrupt.declaration.global());
    }
  }

  void command(InterruptCommand command, int priority, KrlVirtualMachine machine)
      throws KrlExecutionException {
    Interrupt interrupt = declared.get(priority);
    if (interrupt == null) {
      throw new KrlExecutionException(
          KrlExecutionException.NO_INTERRUPT,
          "no interrupt with priority " + priority + " is declared here");
    }
    command(command, interrupt, machine);
  }

  void commandAll(InterruptCommand command, KrlVirtualMachine machine)
      throws KrlExecutionException {
    for (Interrupt interrupt : declared.values()) {
      command(command, interrupt, machine);
    }
  }

  private static void command(
      InterruptCommand command, Interrupt interrupt, KrlVirtualMachine machine)
      throws KrlExecutionException {
    switch (command) {
      case ON -> {
        if (!interrupt.on) {
          // assumed: a condition that is already true is not an edge
          interrupt.last = isTrue(interrupt, machine);
          interrupt.on = true;
        }
      }
      case OFF -> {
        interrupt.on = false;
        interrupt.pending = false;
      }
      case ENABLE -> interrupt.disabled = false;
      case DISABLE -> interrupt.disabled = true;
    }
  }

  private static boolean isTrue(Interrupt interrupt, KrlVirtualMachine machine)
      throws KrlExecutionException {
    return machine.condition(interrupt.declaration.condition(), interrupt.owner);
  }

  /** Detects rising edges. Assumed: edges while the program is stopped are not detected. */
  void watch(KrlVirtualMachine machine) throws KrlExecutionException {
    for (Interrupt interrupt : declared.values()) {
      if (interrupt.on) {
        boolean now = isTrue(interrupt, machine);
        interrupt.pending |= now && !interrupt.last;
        interrupt.last = now;
      }
    }
  }

  void add(Interruption trigger) {
    triggers.add(trigger);
  }

  /**
   * Removes and returns the next interruption of a program with a given priority; null without one.
   */
  @Nullable Interruption next(int priority) {
    Interruption trigger = null;
    for (Interruption candidate : triggers) {
      if (candidate.priority() < (trigger == null ? priority : trigger.priority())) {
        trigger = candidate;
      }
    }
    for (Interrupt interrupt : declared.values()) {
      Declaration declaration = interrupt.declaration;
      if (declaration.priority() >= (trigger == null ? priority : trigger.priority())) {
        break;
      }
      if (interrupt.pending && !interrupt.disabled) {
        interrupt.pending = false;
        return new Interruption(
            declaration.priority(), interrupt.owner, declaration.action(), false);
      }
    }
    if (trigger != null) {
      triggers.remove(trigger);
    }
    return trigger;
  }
}
