package no.hials.crosscom.cli.base;

import java.time.Duration;
import java.util.function.Function;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.cell.HostAndPort;
import no.hials.crosscom.cell.SettingText;
import org.jspecify.annotations.Nullable;

/**
 * The settings of the controller in the environment.
 *
 * @param host {@code JOPENSHOWVAR_HOST}, the controller if no option names one
 * @param port the port there, of {@code JOPENSHOWVAR_HOST} or {@code JOPENSHOWVAR_PORT}
 * @param timeout {@code JOPENSHOWVAR_TIMEOUT}
 * @param readOnly {@code JOPENSHOWVAR_READ_ONLY}, for all controllers
 */
record EnvironmentSettings(
    @Nullable String host, int port, @Nullable Duration timeout, boolean readOnly) {
  private static final String HOST = "JOPENSHOWVAR_HOST";
  private static final String PORT = "JOPENSHOWVAR_PORT";

  /** Reads the settings for a command; an invalid value is wrong usage of the command. */
  static EnvironmentSettings of(ConsoleCommand command) {
    HostAndPort host = converted(command, HOST, HostAndPort::parse);
    Integer port = converted(command, PORT, SettingText::port);
    if (host == null && port != null) {
      throw command.wrongUsage(PORT + " goes with " + HOST);
    }
    return new EnvironmentSettings(
        host == null ? null : host.host(),
        host == null ? 0 : port(command, host, port),
        converted(command, "JOPENSHOWVAR_TIMEOUT", SettingText::time),
        Boolean.TRUE.equals(converted(command, "JOPENSHOWVAR_READ_ONLY", SettingText::flag)));
  }

  private static int port(ConsoleCommand command, HostAndPort host, @Nullable Integer port) {
    try {
      return host.portOr(port, ClientConfig.DEFAULT_PORT);
    } catch (IllegalArgumentException e) {
      throw command.wrongUsage(HOST + " " + e.getMessage());
    }
  }

  private static <T> @Nullable T converted(
      ConsoleCommand command, String name, Function<String, T> converter) {
    String text = command.console().environment(name);
    if (text == null) {
      return null;
    }
    try {
      return converter.apply(text);
    } catch (IllegalArgumentException e) {
      throw command.wrongUsage(name + " " + e.getMessage());
    }
  }
}
