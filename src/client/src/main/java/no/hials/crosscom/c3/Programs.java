package no.hials.crosscom.c3;

import java.util.Objects;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComUnsupportedException;
import no.hials.crosscom.internal.MessageChannel;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.ProgramCommand;
import no.hials.crosscom.protocol.program.ProgramControlRequest;
import no.hials.crosscom.protocol.program.ProgramControlResponse;
import no.hials.crosscom.protocol.program.ProgramSelectRequest;

/**
 * Selects, starts and stops the programs of the controller (c3-bridge.md, type 10).
 *
 * <p><b>Starting a program moves a machine.</b> No command is ever repeated; if the outcome of one
 * is unknown, {@link CrossComException#isOutcomeUnknown} says so. An answer says that the command
 * was accepted; what the interpreter does then, {@code $PRO_STATE1} for the robot interpreter and
 * {@code $PRO_STATE0} for the submit interpreter say.
 *
 * <p>For several threads. All methods block for the request time-out at most, and throw: {@link
 * CrossComUnsupportedException} on KUKAVARPROXY, before the command is sent; {@link
 * CrossComRefusedException} with the server's code if it refused, as it does for a program with
 * errors; another {@link CrossComException} if the exchange failed.
 */
public final class Programs {
  private final MessageChannel link;

  /**
   * Makes the object of a client. For the client; programs get it from {@link
   * no.hials.crosscom.CrossComClient#programs}.
   *
   * @param link sends the messages
   */
  public Programs(MessageChannel link) {
    this.link = link;
  }

  /**
   * Resets the selected program, so that a start begins it anew.
   *
   * @param interpreter whose program
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void reset(Interpreter interpreter) throws CrossComException {
    control(ProgramCommand.RESET, "reset", interpreter);
  }

  /**
   * Starts the selected program, or goes on with one that was stopped.
   *
   * @param interpreter whose program
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void start(Interpreter interpreter) throws CrossComException {
    control(ProgramCommand.START, "start", interpreter);
  }

  /**
   * Stops the running program. This is no emergency stop: it takes a working network.
   *
   * @param interpreter whose program
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void stop(Interpreter interpreter) throws CrossComException {
    control(ProgramCommand.STOP, "stop", interpreter);
  }

  /**
   * Cancels the selection of the program.
   *
   * @param interpreter whose program
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void cancel(Interpreter interpreter) throws CrossComException {
    control(ProgramCommand.CANCEL, "cancellation", interpreter);
  }

  private void control(ProgramCommand command, String noun, Interpreter interpreter)
      throws CrossComException {
    link.ask(
        new ProgramControlRequest(0, Code.of(command), Code.of(interpreter)),
        ProgramControlResponse.class,
        noun
            + " of the "
            + (interpreter == Interpreter.ROBOT ? "robot" : "submit")
            + " interpreter's program");
  }

  /**
   * Selects a program of the robot interpreter, without parameters and without force.
   *
   * @param name such as {@code /R1/MAIN}
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void select(String name) throws CrossComException {
    select(name, "", false);
  }

  /**
   * Selects a program of the robot interpreter.
   *
   * @param name such as {@code /R1/MAIN}
   * @param parameters what the program is called with, as KRL text; empty for none
   * @param force whether to select even if another program is selected (assumed)
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void select(String name, String parameters, boolean force) throws CrossComException {
    choose(ProgramCommand.SELECT, "selection", name, parameters, force);
  }

  /**
   * Selects a program of the robot interpreter and starts it, without parameters and without force.
   *
   * @param name such as {@code /R1/MAIN}
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void run(String name) throws CrossComException {
    run(name, "", false);
  }

  /**
   * Selects a program of the robot interpreter and starts it.
   *
   * @param name such as {@code /R1/MAIN}
   * @param parameters what the program is called with, as KRL text; empty for none
   * @param force whether to select even if another program is selected (assumed)
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void run(String name, String parameters, boolean force) throws CrossComException {
    choose(ProgramCommand.RUN, "run", name, parameters, force);
  }

  private void choose(
      ProgramCommand command, String noun, String name, String parameters, boolean force)
      throws CrossComException {
    if (Objects.requireNonNull(name, "name").isBlank()) {
      throw new IllegalArgumentException("a program's name must not be blank");
    }
    link.ask(
        new ProgramSelectRequest(
            0,
            Code.of(command),
            Code.of(Interpreter.SUBMIT), // the number that is not used is 0 in c3-vectors.tsv
            name,
            Objects.requireNonNull(parameters, "parameters"),
            force),
        ProgramControlResponse.class,
        noun + " of program " + name);
  }
}
