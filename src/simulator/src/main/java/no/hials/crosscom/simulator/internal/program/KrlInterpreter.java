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
 * Executes a program in steps: {@link #run} is called in each cycle of the controller and goes on
 * until the program has to wait.
 *
 * <p>Starts no thread and is not safe for use by several. The motions that it has handed over are
 * the controller's: who stops, resets or cancels the interpreter stops or forgets them.
 */
public final class KrlInterpreter {

  /**
   * A routine that is being executed.
   *
   * @param module the name of its module
   * @param routine its name
   * @param position the statement that is executed; in a calling routine the call
   * @param interrupt whether an interrupt or a trigger has called it
   */
  public record Level(String module, String routine, Position position, boolean interrupt) {}

  private final ProgramEnvironment environment;
  private final KrlVirtualMachine machine;
  private ProgramState state = ProgramState.FREE;
  private @Nullable Program program;
  private List<KrlValue> arguments = List.of();

  /**
   * Makes an interpreter without a program.
   *
   * @param kind which interpreter; only the robot interpreter can move the robot
   * @param environment the controller
   */
  public KrlInterpreter(Interpreter kind, ProgramEnvironment environment) {
    this.environment = environment;
    this.machine = new KrlVirtualMachine(kind, environment);
  }

  /**
   * Selects a program, in place of one that is not active.
   *
   * @param newProgram the program
   * @param newArguments the values of the main routine's first parameters; those behind them stay
   *     without a value
   * @return false if the one selected is active; then nothing has changed
   * @throws KrlExecutionException if the arguments are too many or not of the types of the
   *     parameters; then nothing has changed
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
   * Starts the program or lets it go on; from its end it starts again (assumed).
   *
   * @return false if none is selected or it is active
   */
  public boolean start() {
    if (state == ProgramState.END) {
      reset();
    }
    if (state != ProgramState.RESET && state != ProgramState.STOP) {
      return false;
    }
    state = ProgramState.ACTIVE;
    return true;
  }

  /**
   * Stops the program.
   *
   * @return false if it is not active
   */
  public boolean stop() {
    if (state != ProgramState.ACTIVE) {
      return false;
    }
    state = ProgramState.STOP;
    return true;
  }

  /**
   * Sets the program back to its first line.
   *
   * @return false if none is selected or it is active
   */
  public boolean reset() {
    Program selected = program;
    if (state == ProgramState.ACTIVE || selected == null) {
      return false;
    }
    try {
      machine.begin(selected.main(), arguments);
    } catch (KrlExecutionException e) {
      throw new IllegalStateException("the arguments fitted when the program was selected", e);
    }
    state = ProgramState.RESET;
    return true;
  }

  /**
   * Takes the program away.
   *
   * @return false if none is selected or it is active
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
   * Executes the program until it waits, ends or stops, or the instructions are used up.
   *
   * @param maxInstructions how many instructions may be executed
   * @return how many were
   */
  public int run(int maxInstructions) {
    if (state != ProgramState.ACTIVE) {
      return 0;
    }
    try {
      machine.run(maxInstructions);
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
   * Executes the action of a trigger, at the next {@link #run}.
   *
   * @param trigger one that came with a motion of this interpreter
   */
  public void fire(TriggerOrder trigger) {
    machine.fire(trigger.interruption());
  }

  /**
   * Gives the state.
   *
   * @return what {@code $PRO_STATE} tells
   */
  public ProgramState state() {
    return state;
  }

  /**
   * Gives the selected program.
   *
   * @return the program; nothing in state FREE
   */
  public Optional<Program> program() {
    return Optional.ofNullable(program);
  }

  /**
   * Gives the calls.
   *
   * @return the innermost first; none if no program is selected
   */
  public List<Level> levels() {
    return machine.levels();
  }
}
