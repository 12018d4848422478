package no.hials.crosscom.gateway.internal.opcua;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/**
 * A user of the server.
 *
 * @param name the name, for the log-in and the audit log
 * @param role what the user may do
 * @param passwordFile the file whose first line is the password; null without a password
 * @param certificate the file with the certificate of the user; null without one
 */
record User(String name, Role role, @Nullable Path passwordFile, @Nullable Path certificate) {
  /** The user of clients that do not log in. */
  static final User ANONYMOUS = new User("anonymous", Role.VIEWER, null, null);

  /** The rights of a user. */
  enum Role {
    /** Reads. */
    VIEWER,
    /** Reads, and writes what the configuration allows. */
    OPERATOR
  }
}
