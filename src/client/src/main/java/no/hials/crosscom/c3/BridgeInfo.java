package no.hials.crosscom.c3;

import java.time.Instant;
import no.hials.crosscom.protocol.Version;
import no.hials.crosscom.protocol.code.BuildType;
import no.hials.crosscom.protocol.code.Code;
import org.jspecify.annotations.Nullable;

/**
 * The answer of C3 Bridge Interface about itself
 * (docs/reference/c3-messages.md#information-features-and-confirm-all-13-14-and-63).
 *
 * @param version its version; the third number is always 0
 * @param build its build type, known or not
 * @param clock the controller's clock when it answered, to the ms; null if the server sent no valid
 *     time
 * @param host the controller's computer name
 */
public record BridgeInfo(
    Version version, Code<BuildType> build, @Nullable Instant clock, String host) {}
