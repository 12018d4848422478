package no.hials.crosscom.simulator.internal.program;

import java.util.List;
import java.util.Optional;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import org.jspecify.annotations.Nullable;

/**
 * Executes a program in steps: {@link #run} is called in each cycle of the controller and continues
 * until the program has to wait.
 *
 * <p>Starts no thread and is not thread-safe. The controller owns the motions that the program has
 * started: to stop, reset or cancel the interpreter does not stop them.
 */
public final class KrlInterpreter {

  /** Where a run of a program stops. */
  public enum LineStep {
    /** Nowhere. */
    NONE,
    /** At the next line, also of a routine that is called. */
    INTO,
    /** At the next line of the same routine, or of its caller. */
    OVER
  }

  /**
   * A routine that is being executed.
   *
   * @param module the name of its module
   * @param routine its name
   * @param position the current statement; in a calling routine the call
   * @param interrupt whether an interrupt or a trigger has called it
   */
  public record Level(String module, String routine, Position position, boolean interrupt) {}

  private final ProgramEnvironment environment;
  private final KrlVirtualMachine machine;
  private ProgramState state = ProgramState.FREE;
  private @Nullable Program program;
  private List<KrlValue> arguments = List.of();

  public KrlInterpreter(Interpreter kind, ProgramEnvironment environment) {
    this.environment = environment;
    this.machine = new KrlVirtualMachine(kind, environment);
  }

  /**
   * Selects a program. Replaces the selected program unless it is active.
   *
   * @param newArguments the values of the first parameters of the main routine; the others get no
   *     value
   * @return false if a program is active; then nothing has changed
   * @throws KrlExecutionException if the arguments are too many or have the wrong type; then
   *     nothing has changed
   */
  public boolean select(Program newProgram, List<KrlValue> newArguments)
      throws KrlExecutionException {
    if (state == ProgramState.ACTIVE) {
      return false;
    }
    machine.begin(newProgram.main(), newArguments);
    program = newProgram;
    arguments = List.copyOf(newArguments);
    state = ProgramState.RESET;
    return true;
  }

  /**
   * Starts or continues the program. After its end it starts again (assumed).
   *
   * @return false if no program is selected or it is active
   */
  public boolean start() {
    if (state == ProgramState.END) {
      reset();
    }
    if (state != ProgramState.RESET && state != ProgramState.STOP) {
      return false;
    }
    machine.beginLine();
    state = ProgramState.ACTIVE;
    return true;
  }

  /** Stops the program; returns false if it is not active. */
  public boolean stop() {
    if (state != ProgramState.ACTIVE) {
      return false;
    }
    state = ProgramState.STOP;
    return true;
  }

  /**
   * Resets the program to its first line.
   *
   * @return false if no program is selected or it is active
   */
  public boolean reset() {
    Program selected = program;
    if (state == ProgramState.ACTIVE || selected == null) {
      return false;
    }
    try {
      machine.begin(selected.main(), arguments);
    } catch (KrlExecutionException e) {
      throw new IllegalStateException("the arguments were valid when the program was selected", e);
    }
    state = ProgramState.RESET;
    return true;
  }

  /**
   * Deselects the program.
   *
   * @return false if no program is selected or it is active
   */
  public boolean cancel() {
    if (state == ProgramState.ACTIVE || program == null) {
      return false;
    }
    machine.clear();
    program = null;
    state = ProgramState.FREE;
    return true;
  }

  /**
   * Executes the program until it waits, ends or stops, or the limit is reached.
   *
   * @param maxInstructions the maximum number of instructions
   * @return the number of executed instructions
   */
  public int run(int maxInstructions) {
    return run(maxInstructions, LineStep.NONE);
  }

  /**
   * Executes the program as {@link #run(int)} does, but stops it at its next line.
   *
   * @param step where to stop
   */
  public int run(int maxInstructions, LineStep step) {
    return run(() -> machine.run(maxInstructions, step));
  }

  /**
   * Executes the triggers that have fired, in the cycle in which they have; nothing else.
   *
   * @param maxInstructions the maximum number of instructions
   */
  public void runTriggers(int maxInstructions) {
    int unused = run(() -> machine.runTriggers(maxInstructions));
  }

  private interface Run {
    void execute() throws KrlExecutionException;
  }

  private int run(Run instructions) {
    if (state != ProgramState.ACTIVE) {
      return 0;
    }
    try {
      instructions.execute();
      if (machine.ended()) {
        state = ProgramState.END;
      } else if (machine.halted()) {
        state = ProgramState.STOP;
      }
    } catch (KrlExecutionException fault) {
      state = ProgramState.STOP;
      environment.fault(fault, machine.faultPosition());
    }
    return machine.executed();
  }

  /**
   * Sets the program pointer to the first statement in or after a line of a routine that is being
   * executed; the routines it has called are left.
   *
   * @throws IllegalStateException if no program is selected or it is active
   * @throws IllegalArgumentException if the line is in no such routine
   */
  public void selectLine(int line) {
    if (state == ProgramState.FREE || state == ProgramState.ACTIVE) {
      throw new IllegalStateException(
          "select a line: a program must be selected and not active, is #P_" + state);
    }
    if (state == ProgramState.END) {
      reset();
    }
    machine.selectLine(line);
    state = ProgramState.STOP;
  }

  /**
   * Executes the action of a trigger at the next {@link #run} or {@link #runTriggers}.
   *
   * @param trigger a trigger of a motion of this interpreter
   */
  public void fire(TriggerOrder trigger) {
    machine.fire(trigger.interruption());
  }

  /**
   * Returns whether the robot has to stop.
   *
   * @param stop a stop of a motion of this interpreter
   */
  public boolean isTrue(MotionOrder.Stop stop) throws KrlExecutionException {
    return !machine.ended() && machine.condition(stop.condition(), stop.owner());
  }

  /** Returns whether the program is active and waits for a condition. */
  public boolean waitsForCondition() {
    return state == ProgramState.ACTIVE && machine.waitsForCondition();
  }

  /** Returns the value of {@code $PRO_STATE}. */
  public ProgramState state() {
    return state;
  }

  public Optional<Program> program() {
    return Optional.ofNullable(program);
  }

  /** Returns the calls, the innermost first; empty without a selected program. */
  public List<Level> levels() {
    return machine.levels();
  }
}
