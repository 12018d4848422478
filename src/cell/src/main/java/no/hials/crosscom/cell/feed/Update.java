package no.hials.crosscom.cell.feed;

import java.time.Instant;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * The value that was read from a variable, or the reason why it could not be read.
 *
 * @param variable the variable
 * @param time when the value was read; without a value, when reading it failed
 * @param quality the reliability of the value
 * @param value the value; null without one
 * @param reason why the quality is not good; empty if it is good
 */
public record Update(
    PlannedVariable variable,
    Instant time,
    Quality quality,
    @Nullable KrlValue value,
    String reason) {}
