package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.file.FileResponse;
import no.hials.crosscom.protocol.internal.Layouts;
import no.hials.crosscom.protocol.program.ProgramResponse;
import no.hials.crosscom.protocol.server.ServerResponse;
import no.hials.crosscom.protocol.variable.VariableResponse;

/** An answer that repeats the function of its request and ends with a tail. */
public sealed interface TypedResponse extends Response
    permits VariableResponse,
        TextResponse,
        ProgramResponse,
        ServerResponse,
        FileResponse,
        PlainResponse {

  /**
   * Returns the type of the request.
   *
   * @return the type
   */
  default MessageType type() {
    return Layouts.type(getClass());
  }

  /**
   * Returns the end of the answer.
   *
   * @return the last three bytes
   */
  Tail tail();
}
