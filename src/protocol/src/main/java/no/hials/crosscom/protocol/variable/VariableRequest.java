package no.hials.crosscom.protocol.variable;

import no.hials.crosscom.protocol.Request;

/** Reads or writes variables, or measures how long that takes. */
public sealed interface VariableRequest extends Request
    permits BenchmarkReadRequest,
        BenchmarkWriteRequest,
        ReadArrayRequest,
        ReadMultipleRequest,
        ReadRequest,
        ReadUtf16Request,
        WriteArrayRequest,
        WriteMultipleRequest,
        WriteRequest,
        WriteUtf16Request {}
