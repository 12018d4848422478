package no.hials.crosscom.gateway.internal.opcua;

import java.util.List;

/**
 * The settings of the server.
 *
 * @param host the address to listen on
 * @param port the port; 0 for a free one
 * @param loopback whether only this computer reaches the address
 * @param users the users who log in
 * @param anonymous whether clients without a user may read
 * @param allowNone whether connections without encryption are allowed
 */
record OpcUaSettings(
    String host,
    int port,
    boolean loopback,
    List<User> users,
    boolean anonymous,
    boolean allowNone) {
  OpcUaSettings {
    users = List.copyOf(users);
  }
}
