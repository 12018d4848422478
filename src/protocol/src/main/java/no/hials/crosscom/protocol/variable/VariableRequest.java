package no.hials.crosscom.protocol.variable;

import no.hials.crosscom.protocol.Request;

/** Asks to read or write variables, or to measure how long that takes. */
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
