package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.file.FileRequest;
import no.hials.crosscom.protocol.program.ProgramRequest;
import no.hials.crosscom.protocol.server.ServerRequest;
import no.hials.crosscom.protocol.variable.VariableRequest;

/** A message from the client to the server. */
public sealed interface Request
    permits VariableRequest, ProgramRequest, FileRequest, ServerRequest {

  /**
   * Gives the number by which the answer is known.
   *
   * @return 0 to 65535
   */
  int id();

  /**
   * Gives the type.
   *
   * @return the type of this message
   */
  MessageType type();
}
