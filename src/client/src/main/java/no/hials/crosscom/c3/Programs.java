package no.hials.crosscom.c3;

import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComUnsupportedException;
import no.hials.crosscom.protocol.code.Interpreter;

/**
 * Selects, starts and stops the programs of the controller
 * (docs/reference/c3-messages.md#program-control-10).
 *
 * <p><b>Starting a program moves a machine.</b> No command is ever repeated. If its outcome is
 * unknown, {@link CrossComException#isOutcomeUnknown} returns true. An answer means that the
 * command was accepted. {@code $PRO_STATE1} shows the state of the robot interpreter, {@code
 * $PRO_STATE0} that of the submit interpreter.
 *
 * <p>Thread-safe. All methods block for at most the request time-out. They throw {@link
 * CrossComUnsupportedException} on KUKAVARPROXY, before the command is sent; {@link
 * CrossComRefusedException} with the server's code if it refuses, for example a program with
 * errors; another {@link CrossComException} if the exchange fails.
 *
 * <p>Programs get this object from {@link no.hials.crosscom.CrossComClient#programs}.
 */
public interface Programs {
  /**
   * Resets the selected program, so that a start begins at its first line.
   *
   * @param interpreter runs the program
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  void reset(Interpreter interpreter) throws CrossComException;

  /**
   * Starts the selected program, or continues one that was stopped.
   *
   * @param interpreter runs the program
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  void start(Interpreter interpreter) throws CrossComException;

  /**
   * Stops the running program. This is not an emergency stop: it needs a working network.
   *
   * @param interpreter runs the program
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  void stop(Interpreter interpreter) throws CrossComException;

  /**
   * Cancels the selection of the program.
   *
   * @param interpreter runs the program
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  void cancel(Interpreter interpreter) throws CrossComException;

  /**
   * Selects a program of the robot interpreter, without parameters and without force.
   *
   * @param name such as {@code /R1/MAIN}
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  default void select(String name) throws CrossComException {
    select(name, "", false);
  }

  /**
   * Selects a program of the robot interpreter.
   *
   * @param name such as {@code /R1/MAIN}
   * @param parameters the program's arguments as KRL text; empty for none
   * @param force whether to select even if another program is selected (assumed)
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  void select(String name, String parameters, boolean force) throws CrossComException;

  /**
   * Selects a program of the robot interpreter and starts it, without parameters and without force.
   *
   * @param name such as {@code /R1/MAIN}
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  default void run(String name) throws CrossComException {
    run(name, "", false);
  }

  /**
   * Selects a program of the robot interpreter and starts it.
   *
   * @param name such as {@code /R1/MAIN}
   * @param parameters the program's arguments as KRL text; empty for none
   * @param force whether to select even if another program is selected (assumed)
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  void run(String name, String parameters, boolean force) throws CrossComException;
}
