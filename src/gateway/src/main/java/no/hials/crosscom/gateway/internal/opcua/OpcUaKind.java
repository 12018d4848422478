package no.hials.crosscom.gateway.internal.opcua;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.HostAndPort;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.gateway.GatewayContext;
import no.hials.crosscom.gateway.Output;
import no.hials.crosscom.gateway.OutputKind;

/** The table {@code opcua}: a server for OPC UA clients. */
public final class OpcUaKind implements OutputKind<OpcUaSettings> {
  private static final int PORT = 4840;
  private static final String ADDRESS = "address";
  private static final String ANONYMOUS = "anonymous";
  private static final String ALLOW_NONE = "allow-none";
  private static final String USERS = "users";
  private static final String ROLE = "role";
  private static final String PASSWORD_FILE = "password-file";
  private static final String CERTIFICATE = "certificate";

  @Override
  public String table() {
    return "opcua";
  }

  @Override
  public OpcUaSettings read(TomlTable table) throws FileException {
    table.allow(ADDRESS, ANONYMOUS, ALLOW_NONE, USERS);
    HostAndPort given =
        table.converted(
            ADDRESS, text -> HostAndPort.listening(text, PORT), TomlTable.TEXT, String.class);
    HostAndPort address = given == null ? new HostAndPort("127.0.0.1", PORT) : given;
    boolean loopback = isLoopback(table, address.host());
    List<User> users = new ArrayList<>();
    for (TomlTable user : table.tables(USERS)) {
      users.add(user(user));
    }
    if (!loopback && users.isEmpty()) {
      throw table.error(
          ADDRESS,
          address.host()
              + " can be reached from other computers: it needs a user, such as"
              + " [opcua.users.anna] with role and password-file");
    }
    boolean anonymous = table.has(ANONYMOUS) ? table.flag(ANONYMOUS) : loopback;
    if (!anonymous && users.isEmpty()) {
      throw table.error(ANONYMOUS, "must be true without users, or nobody can log in");
    }
    return new OpcUaSettings(
        address.host(),
        Objects.requireNonNull(address.port()),
        loopback,
        users,
        anonymous,
        loopback || table.flag(ALLOW_NONE));
  }

  private static boolean isLoopback(TomlTable table, String host) throws FileException {
    try {
      return InetAddress.getByName(host).isLoopbackAddress();
    } catch (UnknownHostException e) {
      throw table.error(ADDRESS, host + " cannot be resolved to an address");
    }
  }

  private static User user(TomlTable table) throws FileException {
    table.allow(ROLE, PASSWORD_FILE, CERTIFICATE);
    String role = table.text(ROLE);
    if (role == null || !(role.equals("operator") || role.equals("viewer"))) {
      throw table.error(
          ROLE, "must be \"operator\" or \"viewer\"" + (role == null ? "" : ", is " + role));
    }
    Path password = table.file(PASSWORD_FILE);
    Path certificate = table.file(CERTIFICATE);
    if (password == null && certificate == null) {
      throw table.error("needs a password-file or a certificate");
    }
    try {
      if (password != null) {
        Users.passwordOf(password);
      }
    } catch (IOException e) {
      throw table.error(PASSWORD_FILE, String.valueOf(e.getMessage()));
    }
    try {
      if (certificate != null) {
        Users.certificateOf(certificate);
      }
    } catch (IOException e) {
      throw table.error(CERTIFICATE, String.valueOf(e.getMessage()));
    }
    return new User(
        table.name(), User.Role.valueOf(role.toUpperCase(Locale.ROOT)), password, certificate);
  }

  @Override
  public Output open(OpcUaSettings settings, GatewayContext context) throws IOException {
    return new OpcUaOutput(settings, context);
  }
}
