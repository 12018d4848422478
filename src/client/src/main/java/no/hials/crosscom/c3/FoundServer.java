package no.hials.crosscom.c3;

import java.net.InetAddress;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Version;
import org.jspecify.annotations.Nullable;

/**
 * A server that answered a {@link Discovery}.
 *
 * @param address where it answered from
 * @param port its TCP port; 7000 if it did not say, as KUKAVARPROXY
 * @param model the robot's model, such as {@code #KR6R900 C4}; empty if the controller could not be
 *     asked
 * @param serialNumber the robot's serial number; empty in the same case
 * @param type C3 Bridge if it said so, else KUKAVARPROXY
 * @param version its version; null if it did not say, as KUKAVARPROXY
 */
public record FoundServer(
    InetAddress address,
    int port,
    String model,
    String serialNumber,
    ServerType type,
    @Nullable Version version) {}
