package no.hials.crosscom.internal.c3;

import java.util.Objects;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.c3.Programs;
import no.hials.crosscom.internal.MessageChannel;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.ProgramCommand;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramControlRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramSelectRequest;
import no.hials.crosscom.protocol.program.ProgramResponse;

/** Controls programs by messages of type 10. */
public final class C3Programs implements Programs {
  private final MessageChannel channel;

  public C3Programs(MessageChannel channel) {
    this.channel = channel;
  }

  @Override
  public void reset(Interpreter interpreter) throws CrossComException {
    control(ProgramCommand.RESET, "reset", interpreter);
  }

  @Override
  public void start(Interpreter interpreter) throws CrossComException {
    control(ProgramCommand.START, "start", interpreter);
  }

  @Override
  public void stop(Interpreter interpreter) throws CrossComException {
    control(ProgramCommand.STOP, "stop", interpreter);
  }

  @Override
  public void cancel(Interpreter interpreter) throws CrossComException {
    control(ProgramCommand.CANCEL, "cancellation", interpreter);
  }

  private void control(ProgramCommand command, String noun, Interpreter interpreter)
      throws CrossComException {
    Objects.requireNonNull(interpreter, "interpreter");
    channel.ask(
        new ProgramControlRequest(0, Code.of(command), Code.of(interpreter)),
        ProgramResponse.class,
        noun
            + " of the "
            + (interpreter == Interpreter.ROBOT ? "robot" : "submit")
            + " interpreter's program");
  }

  @Override
  public void select(String name, String parameters, boolean force) throws CrossComException {
    choose(ProgramCommand.SELECT, "selection", name, parameters, force);
  }

  @Override
  public void run(String name, String parameters, boolean force) throws CrossComException {
    choose(ProgramCommand.RUN, "run", name, parameters, force);
  }

  private void choose(
      ProgramCommand command, String noun, String name, String parameters, boolean force)
      throws CrossComException {
    if (Objects.requireNonNull(name, "name").isBlank()) {
      throw new IllegalArgumentException("a program's name must not be blank");
    }
    channel.ask(
        new ProgramSelectRequest(
            0,
            Code.of(command),
            Code.of(Interpreter.SUBMIT), // not used; 0 in C3 Bridge's own examples
            name,
            Objects.requireNonNull(parameters, "parameters"),
            force),
        ProgramResponse.class,
        noun + " of program " + name);
  }
}
