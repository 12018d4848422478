package no.hials.crosscom.protocol;

/** An answer that repeats the function of its request and says how the access ended. */
public sealed interface TypedResponse extends Response
    permits ReadResponse,
        WriteResponse,
        ReadArrayResponse,
        WriteArrayResponse,
        TextResponse,
        MultipleResponse,
        ProgramControlResponse,
        MotionResponse,
        PendantKeyResponse,
        InformationResponse,
        FeaturesResponse,
        BenchmarkResponse,
        ListDirectoryResponse,
        FilePropertiesResponse,
        ContentSizeResponse,
        WriteDataResponse,
        ReadDataResponse,
        ContentResponse,
        PlainResponse {

  /**
   * Gives the type.
   *
   * @return the type of the request
   */
  MessageType type();

  /**
   * Says how the access ended.
   *
   * @return the last three bytes
   */
  Tail tail();
}
