package no.hials.crosscom.cli;

import java.math.BigDecimal;
import java.time.Duration;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.simulator.SimulationClock;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** How the texts of options become values. */
final class Converters {
  private Converters() {}

  private static int number(String text, int min, int max) {
    try {
      int number = Integer.parseInt(text);
      if (number >= min && number <= max) {
        return number;
      }
    } catch (NumberFormatException e) {
      // said below
    }
    throw new TypeConversionException("must be " + min + " to " + max + ", is " + text);
  }

  /** A port to connect to. */
  static final class Port implements ITypeConverter<Integer> {
    @Override
    public Integer convert(String text) {
      return number(text, 1, 65_535);
    }
  }

  /** A port to listen on, 0 for a free one. */
  static final class ListeningPort implements ITypeConverter<Integer> {
    @Override
    public Integer convert(String text) {
      return number(text, 0, 65_535);
    }
  }

  /** Yes or no, of the environment. */
  static final class Flag implements ITypeConverter<Boolean> {
    @Override
    public Boolean convert(String text) {
      return switch (text.toLowerCase(Locale.ROOT)) {
        case "true", "1" -> true;
        case "false", "0" -> false;
        default -> throw new TypeConversionException("must be true or false, is " + text);
      };
    }
  }

  /** The server of a simulated controller. */
  static final class Server implements ITypeConverter<ServerType>, Iterable<String> {
    @Override
    public Iterator<String> iterator() {
      return List.of("kukavarproxy", "c3").iterator();
    }

    @Override
    public ServerType convert(String text) {
      return switch (text.toLowerCase(Locale.ROOT)) {
        case "kukavarproxy" -> ServerType.KUKAVARPROXY;
        case "c3" -> ServerType.C3_BRIDGE;
        default -> throw new TypeConversionException("must be kukavarproxy or c3, is " + text);
      };
    }
  }

  /** An operating mode. */
  static final class Mode implements ITypeConverter<OperatingMode> {
    @Override
    public OperatingMode convert(String text) {
      try {
        return OperatingMode.valueOf(text.toUpperCase(Locale.ROOT));
      } catch (IllegalArgumentException e) {
        throw new TypeConversionException("must be T1, T2, AUT or EXT, is " + text);
      }
    }
  }

  /** How fast the time of the simulated controller passes. */
  static final class Speed implements ITypeConverter<SimulationClock> {
    @Override
    public SimulationClock convert(String text) {
      try {
        SimulationClock clock = SimulationClock.parse(text);
        // a test steps it; here it would stand still for ever
        if (!(clock instanceof SimulationClock.Stepped)) {
          return clock;
        }
      } catch (IllegalArgumentException e) {
        // said below
      }
      throw new TypeConversionException(
          "must be real, max, or a factor of more than 0 and at most 10000, is " + text);
    }
  }

  /** The seed of what happens by chance. */
  static final class Seed implements ITypeConverter<Long> {
    @Override
    public Long convert(String text) {
      try {
        return Long.valueOf(text);
      } catch (NumberFormatException e) {
        throw new TypeConversionException("must be a whole number, is " + text);
      }
    }
  }

  /** A time of at least 1 ms: {@code 500}, {@code 500ms}, {@code 1.5s}, {@code 1m}. */
  static final class Time implements ITypeConverter<Duration> {
    private static final Pattern FORM =
        Pattern.compile("(\\d{1,10}(?:\\.\\d{1,9})?)\\s?(ms|s|m|min|)", Pattern.CASE_INSENSITIVE);

    @Override
    public Duration convert(String text) {
      Matcher matcher = FORM.matcher(text);
      if (!matcher.matches()) {
        throw new TypeConversionException("must be like 500, 500ms, 3s or 1m, is " + text);
      }
      int unit =
          switch (matcher.group(2).toLowerCase(Locale.ROOT)) {
            case "s" -> 1000;
            case "m", "min" -> 60_000;
            default -> 1;
          };
      long millis = new BigDecimal(matcher.group(1)).multiply(BigDecimal.valueOf(unit)).longValue();
      if (millis < 1 || millis > Integer.MAX_VALUE) {
        throw new TypeConversionException("must be 1ms to " + Integer.MAX_VALUE + "ms, is " + text);
      }
      return Duration.ofMillis(millis);
    }
  }
}
