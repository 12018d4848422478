package no.hials.crosscom.cell.feed;

import java.time.Instant;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * A reading of a variable, or why there is none.
 *
 * @param variable the variable
 * @param time when the value was read; without a value, when reading it failed
 * @param quality how far it can be relied on
 * @param value the value; null if there is none
 * @param reason why the quality is not good; empty if it is
 */
public record Update(
    PlannedVariable variable,
    Instant time,
    Quality quality,
    @Nullable KrlValue value,
    String reason) {}
