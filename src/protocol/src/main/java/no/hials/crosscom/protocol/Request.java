package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.file.FileRequest;
import no.hials.crosscom.protocol.internal.Layouts;
import no.hials.crosscom.protocol.program.ProgramRequest;
import no.hials.crosscom.protocol.server.ServerRequest;
import no.hials.crosscom.protocol.variable.VariableRequest;

/** A message from the client to the server, in one of four families. */
public sealed interface Request
    permits VariableRequest, ProgramRequest, FileRequest, ServerRequest {

  /**
   * Returns the number that the answer repeats.
   *
   * @return 0 to 65535
   */
  int id();

  /**
   * Returns the type of the message.
   *
   * @return the type
   */
  default MessageType type() {
    return Layouts.type(getClass());
  }
}
