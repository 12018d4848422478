package no.hials.crosscom.protocol.program;

import no.hials.crosscom.protocol.Request;

/** Controls programs, moves the robot or presses a key of the pendant. */
public sealed interface ProgramRequest extends Request
    permits MotionRequest, PendantKeyRequest, ProgramControlRequest, ProgramSelectRequest {}
