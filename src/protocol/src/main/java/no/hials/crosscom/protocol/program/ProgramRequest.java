package no.hials.crosscom.protocol.program;

import no.hials.crosscom.protocol.Request;

/** Asks to control programs, to move the robot or to press a key of the pendant. */
public sealed interface ProgramRequest extends Request
    permits MotionRequest, PendantKeyRequest, ProgramControlRequest, ProgramSelectRequest {}
