package no.hials.crosscom.cli.bridge;

import java.io.IOException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * The state of an interpreter, from its variables.
 *
 * @param interpreter the interpreter
 * @param program the name of the selected program, blank if none is; null if it could not be read
 * @param state such as {@code #P_ACTIVE}; null if it could not be read
 */
record ProgramStatus(Interpreter interpreter, @Nullable String program, @Nullable String state) {

  /**
   * Reads the state. Variables that cannot be read are left out: the state is only an addition to
   * the result.
   */
  static ProgramStatus read(CrossComClient client, Interpreter interpreter) throws IOException {
    int number = interpreter.code();
    return new ProgramStatus(
        interpreter,
        text(client, "$PRO_NAME" + number + "[]"),
        text(client, "$PRO_STATE" + number));
  }

  private static @Nullable String text(CrossComClient client, String name) throws IOException {
    try {
      KrlValue value = client.readValue(name);
      return value instanceof KrlString string ? string.text() : value.toString();
    } catch (CrossComException e) {
      return null;
    }
  }

  /** Prints a line such as {@code robot: ACTUATOR #P_ACTIVE}, or an object of JSON. */
  void print(BridgeCommand command, String verb) {
    String who = interpreter == Interpreter.ROBOT ? "robot" : "submit";
    String name = program == null ? "program unknown" : program.strip();
    command.print(
        who
            + ": "
            + (name.isEmpty() ? "no program" : name)
            + " "
            + (state == null ? "state unknown" : state),
        "command",
        verb,
        "interpreter",
        who,
        "program",
        program == null ? null : program.strip(),
        "state",
        state);
  }
}
