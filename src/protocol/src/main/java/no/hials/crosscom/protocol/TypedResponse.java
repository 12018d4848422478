package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.file.FileResponse;
import no.hials.crosscom.protocol.internal.Layouts;
import no.hials.crosscom.protocol.program.ProgramResponse;
import no.hials.crosscom.protocol.server.FeaturesResponse;
import no.hials.crosscom.protocol.server.InformationResponse;
import no.hials.crosscom.protocol.variable.BenchmarkResponse;
import no.hials.crosscom.protocol.variable.MultipleResponse;
import no.hials.crosscom.protocol.variable.ReadArrayResponse;
import no.hials.crosscom.protocol.variable.ValueResponse;

/** An answer that repeats the function of its request and ends with a tail. */
public sealed interface TypedResponse extends Response
    permits ValueResponse,
        ReadArrayResponse,
        TextResponse,
        MultipleResponse,
        ProgramResponse,
        InformationResponse,
        FeaturesResponse,
        BenchmarkResponse,
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
