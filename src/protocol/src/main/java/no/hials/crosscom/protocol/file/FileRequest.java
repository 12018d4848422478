package no.hials.crosscom.protocol.file;

import no.hials.crosscom.protocol.Request;

/** Asks about the files of the controller, or asks to change them. */
public sealed interface FileRequest extends Request
    permits BeginReadRequest,
        BeginWriteRequest,
        ContentRequest,
        CopyFileRequest,
        CreateFileRequest,
        DeleteFileRequest,
        EndWriteRequest,
        FileNameRequest,
        FilePropertiesRequest,
        ListDirectoryRequest,
        ReadDataRequest,
        SetAttributesRequest,
        WriteDataRequest {}
