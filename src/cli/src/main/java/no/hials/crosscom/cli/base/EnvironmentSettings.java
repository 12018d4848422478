package no.hials.crosscom.cli.base;

import java.time.Duration;
import java.util.function.Function;
import no.hials.crosscom.cell.SettingText;
import org.jspecify.annotations.Nullable;

/**
 * The settings of the controller in the environment.
 *
 * @param host {@code JOPENSHOWVAR_HOST}, the controller if no option names one
 * @param port {@code JOPENSHOWVAR_PORT}, the port there
 * @param timeout {@code JOPENSHOWVAR_TIMEOUT}
 * @param readOnly {@code JOPENSHOWVAR_READ_ONLY}, for whatever controller
 */
record EnvironmentSettings(
    @Nullable String host, @Nullable Integer port, @Nullable Duration timeout, boolean readOnly) {
  private static final String HOST = "JOPENSHOWVAR_HOST";
  private static final String PORT = "JOPENSHOWVAR_PORT";

  /** Reads it for a command, whose wrong usage a wrong value is. */
  static EnvironmentSettings of(ConsoleCommand command) {
    String host = command.console().environment(HOST);
    Integer port = converted(command, PORT, SettingText::port);
    if (host == null && port != null) {
      throw command.wrongUsage(PORT + " goes with " + HOST);
    }
    return new EnvironmentSettings(
        host,
        port,
        converted(command, "JOPENSHOWVAR_TIMEOUT", SettingText::time),
        Boolean.TRUE.equals(converted(command, "JOPENSHOWVAR_READ_ONLY", SettingText::flag)));
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
