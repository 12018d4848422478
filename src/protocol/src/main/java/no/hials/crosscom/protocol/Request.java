package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.file.BeginReadRequest;
import no.hials.crosscom.protocol.file.BeginWriteRequest;
import no.hials.crosscom.protocol.file.ContentRequest;
import no.hials.crosscom.protocol.file.CopyFileRequest;
import no.hials.crosscom.protocol.file.CreateFileRequest;
import no.hials.crosscom.protocol.file.DeleteFileRequest;
import no.hials.crosscom.protocol.file.EndWriteRequest;
import no.hials.crosscom.protocol.file.FileNameRequest;
import no.hials.crosscom.protocol.file.FilePropertiesRequest;
import no.hials.crosscom.protocol.file.ListDirectoryRequest;
import no.hials.crosscom.protocol.file.ReadDataRequest;
import no.hials.crosscom.protocol.file.SetAttributesRequest;
import no.hials.crosscom.protocol.file.WriteDataRequest;
import no.hials.crosscom.protocol.program.MotionRequest;
import no.hials.crosscom.protocol.program.PendantKeyRequest;
import no.hials.crosscom.protocol.program.ProgramControlRequest;
import no.hials.crosscom.protocol.program.ProgramSelectRequest;
import no.hials.crosscom.protocol.server.ServerRequest;
import no.hials.crosscom.protocol.variable.BenchmarkReadRequest;
import no.hials.crosscom.protocol.variable.BenchmarkWriteRequest;
import no.hials.crosscom.protocol.variable.ReadArrayRequest;
import no.hials.crosscom.protocol.variable.ReadMultipleRequest;
import no.hials.crosscom.protocol.variable.ReadRequest;
import no.hials.crosscom.protocol.variable.ReadUtf16Request;
import no.hials.crosscom.protocol.variable.WriteArrayRequest;
import no.hials.crosscom.protocol.variable.WriteMultipleRequest;
import no.hials.crosscom.protocol.variable.WriteRequest;
import no.hials.crosscom.protocol.variable.WriteUtf16Request;

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
        ServerRequest,
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
