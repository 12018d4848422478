package no.hials.crosscom.simulator;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.internal.core.ControllerCore;
import no.hials.crosscom.simulator.internal.program.KrlInterpreter;

/**
 * An interpreter of the simulated controller: selects a program and runs it. A call that the state
 * does not allow throws an {@link IllegalStateException} with the reason, and changes nothing.
 */
public final class ProgramControl {
  private final ControllerCore core;
  private final Interpreter kind;

  ProgramControl(ControllerCore core, Interpreter kind) {
    this.core = core;
    this.kind = kind;
  }

  /**
   * Selects a program, which replaces a selected program that is not active.
   *
   * @param name the name of its module, in any case
   * @throws KrlFileException if the module or one of its callees has errors or does not exist
   */
  public void select(String name) throws KrlFileException {
    select(name, List.of());
  }

  /**
   * Selects a program with values for its first parameters.
   *
   * @param name the name of its module, in any case
   * @param arguments the values
   * @throws KrlFileException if the module or one of its callees has errors or does not exist
   * @throws IllegalArgumentException if the values do not match the parameters
   */
  public void select(String name, List<KrlValue> arguments) throws KrlFileException {
    try {
      core.select(kind, name, arguments);
    } catch (KrlExecutionException e) {
      throw new IllegalArgumentException(name + ": " + e.getMessage(), e);
    }
  }

  /** Starts the selected program or continues it; after its end it starts again. */
  public void start() {
    core.start(kind, false);
  }

  /**
   * Sets the program pointer to a line, as a block selection does. The program stays stopped, and a
   * BCO run is due. A FOR or SWITCH that is not running cannot be continued from a line in it.
   *
   * @param line a line of a routine that is being executed, or of the main routine; without a
   *     statement, the next one with a statement
   * @throws IllegalArgumentException if the line is in no such routine
   * @throws IllegalStateException if this is the submit interpreter
   */
  public void selectLine(int line) {
    if (kind == Interpreter.SUBMIT) {
      throw new IllegalStateException("select a line: only in the robot interpreter");
    }
    core.selectLine(line);
  }

  /** Stops the program if it is active; the robot slows down on its path. */
  public void stop() {
    core.stop(kind);
  }

  /** Stops the program and sets it back to its beginning. */
  public void reset() {
    core.reset(kind);
  }

  /** Stops the program and deselects it. */
  public void cancel() {
    core.cancel(kind);
  }

  /**
   * Returns the state.
   *
   * @return the value of {@code $PRO_STATE0} or {@code $PRO_STATE1}
   */
  public ProgramState state() {
    return core.state(kind);
  }

  /**
   * Returns the selected program.
   *
   * @return the name of its module; empty if none is selected
   */
  public Optional<String> program() {
    return core.program(kind);
  }

  /**
   * Returns the line of the program pointer.
   *
   * @return the line in the file of the innermost routine; 0 if no program is selected
   */
  public int line() {
    List<KrlInterpreter.Level> levels = core.levels(kind);
    return levels.isEmpty() ? 0 : levels.get(0).position().line();
  }

  /**
   * Returns whether the program waits for a condition of {@code WAIT FOR}.
   *
   * @return true if it is active and has not gone on in the last cycle
   */
  public boolean waitsForCondition() {
    return core.waitsForCondition(kind);
  }

  /**
   * Returns the program, its state and its line. In a routine of another module the line has the
   * module's name; a routine that is built in has the line of its call.
   */
  @Override
  public String toString() {
    return program()
        .map(name -> name + " #" + state().constant() + " line " + lineOf(name))
        .orElse("no program");
  }

  private String lineOf(String program) {
    List<KrlInterpreter.Level> levels = core.levels(kind);
    Set<String> loaded = core.withLibrary(library -> library.names());
    KrlInterpreter.Level shown =
        levels.stream()
            .filter(level -> loaded.contains(level.module()))
            .findFirst()
            .orElse(levels.isEmpty() ? null : levels.get(levels.size() - 1));
    if (shown == null) {
      return "0";
    }
    String line = String.valueOf(shown.position().line());
    return shown.module().equalsIgnoreCase(program) ? line : line + " of " + shown.module();
  }
}
