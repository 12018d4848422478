package no.hials.crosscom.cell;

import java.math.BigDecimal;
import java.nio.charset.Charset;
import java.time.Duration;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.protocol.ServerType;

/**
 * Parses the texts of options, environment variables and configuration files. An invalid text
 * throws an {@link IllegalArgumentException} with the expected and the actual text.
 */
public final class SettingText {
  private static final Pattern ROBOT_NAME = Pattern.compile("\\w[\\w.-]*");
  private static final Pattern TIME =
      Pattern.compile("(\\d{1,10}(?:\\.\\d{1,9})?)\\s?(ms|s|m|min|)", Pattern.CASE_INSENSITIVE);

  private SettingText() {}

  /** Returns whether {@code @NAME} can stand for a robot of this name. */
  public static boolean isRobotName(String name) {
    return ROBOT_NAME.matcher(name).matches();
  }

  /** Parses a port to connect to. */
  public static int port(String text) {
    return number(text, 1, 65_535);
  }

  /** Parses a whole number. */
  public static int number(String text, int min, int max) {
    try {
      int number = Integer.parseInt(text);
      if (number >= min && number <= max) {
        return number;
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw new IllegalArgumentException("must be " + min + " to " + max + ", is " + text);
  }

  /** Parses a truth value of the environment. */
  public static boolean flag(String text) {
    return switch (text.toLowerCase(Locale.ROOT)) {
      case "true", "1" -> true;
      case "false", "0" -> false;
      default -> throw new IllegalArgumentException("must be true or false, is " + text);
    };
  }

  /** Parses the type of a server. */
  public static ServerType server(String text) {
    return switch (text.toLowerCase(Locale.ROOT)) {
      case "kukavarproxy" -> ServerType.KUKAVARPROXY;
      case "c3" -> ServerType.C3_BRIDGE;
      default -> throw new IllegalArgumentException("must be kukavarproxy or c3, is " + text);
    };
  }

  /** Parses the name of a charset that KUKAVARPROXY can have. */
  public static Charset charset(String text) {
    Charset charset;
    try {
      charset = Charset.forName(text);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException("must be a charset such as windows-1251, is " + text, e);
    }
    return ClientConfig.create("robot", cfg -> cfg.charset(charset)).charset();
  }

  /** Parses a time of at least 1 ms: {@code 500}, {@code 500ms}, {@code 1.5s}, {@code 1m}. */
  public static Duration time(String text) {
    Matcher matcher = TIME.matcher(text);
    if (!matcher.matches()) {
      throw new IllegalArgumentException("must be like 500, 500ms, 3s or 1m, is " + text);
    }
    int unit =
        switch (matcher.group(2).toLowerCase(Locale.ROOT)) {
          case "s" -> 1000;
          case "m", "min" -> 60_000;
          default -> 1;
        };
    long millis = new BigDecimal(matcher.group(1)).multiply(BigDecimal.valueOf(unit)).longValue();
    // not the whole range: an option may have a smaller one
    if (millis < 1) {
      throw new IllegalArgumentException("must be 1ms or more, is " + text);
    }
    if (millis > Integer.MAX_VALUE) {
      throw new IllegalArgumentException("must be at most " + Integer.MAX_VALUE + "ms, is " + text);
    }
    return Duration.ofMillis(millis);
  }
}
