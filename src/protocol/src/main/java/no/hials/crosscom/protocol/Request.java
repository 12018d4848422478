package no.hials.crosscom.protocol;

/** A message from the client to the server. */
public sealed interface Request
    permits ReadRequest,
        WriteRequest,
        ReadArrayRequest,
        WriteArrayRequest,
        ReadUtf16Request,
        WriteUtf16Request,
        ReadMultipleRequest,
        WriteMultipleRequest,
        ProgramControlRequest,
        ProgramSelectRequest,
        MotionRequest,
        PendantKeyRequest,
        PlainRequest,
        BenchmarkReadRequest,
        BenchmarkWriteRequest,
        SetAttributesRequest,
        ListDirectoryRequest,
        CreateFileRequest,
        DeleteFileRequest,
        CopyFileRequest,
        FileNameRequest,
        FilePropertiesRequest,
        BeginWriteRequest,
        WriteDataRequest,
        EndWriteRequest,
        BeginReadRequest,
        ReadDataRequest,
        ContentRequest {

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
