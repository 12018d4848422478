package no.hials.crosscom.cli.base;

import java.nio.charset.Charset;
import java.time.Duration;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import no.hials.crosscom.cell.SettingText;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.simulator.SimulationClock;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** How the texts of options become values. */
public final class Converters {
  private Converters() {}

  /** Converts a text, and reports errors as picocli does. */
  static <T> T converted(Function<String, T> parser, String text) {
    try {
      return parser.apply(text);
    } catch (IllegalArgumentException e) {
      throw new TypeConversionException(String.valueOf(e.getMessage()));
    }
  }

  /** A port to connect to. */
  static final class Port implements ITypeConverter<Integer> {
    @Override
    public Integer convert(String text) {
      return converted(SettingText::port, text);
    }
  }

  /** A port to listen on, 0 for a free one. */
  public static final class ListeningPort implements ITypeConverter<Integer> {
    @Override
    public Integer convert(String text) {
      return converted(port -> SettingText.number(port, 0, 65_535), text);
    }
  }

  /** The charset of texts on KUKAVARPROXY. */
  static final class CharsetName implements ITypeConverter<Charset> {
    @Override
    public Charset convert(String text) {
      return converted(SettingText::charset, text);
    }
  }

  /** The server of a simulated controller. */
  public static final class ServerName implements ITypeConverter<ServerType>, Iterable<String> {
    @Override
    public Iterator<String> iterator() {
      return List.of("kukavarproxy", "c3").iterator();
    }

    @Override
    public ServerType convert(String text) {
      return converted(SettingText::server, text);
    }
  }

  /** An operating mode. */
  public static final class Mode implements ITypeConverter<OperatingMode> {
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
  public static final class ClockSpeed implements ITypeConverter<SimulationClock> {
    @Override
    public SimulationClock convert(String text) {
      try {
        SimulationClock clock = SimulationClock.parse(text);
        // a stepped clock is for tests; here nothing would step it
        if (!(clock instanceof SimulationClock.Stepped)) {
          return clock;
        }
      } catch (IllegalArgumentException e) {
        // reported below
      }
      throw new TypeConversionException(
          "must be real, max, or a factor of more than 0 and at most 10000, is " + text);
    }
  }

  /** A whole number of 64 bits. */
  public static final class WholeNumber implements ITypeConverter<Long> {
    @Override
    public Long convert(String text) {
      return number(Long::valueOf, "a whole number up to " + Long.MAX_VALUE, text);
    }
  }

  /** A whole number of 32 bits. */
  public static final class SmallNumber implements ITypeConverter<Integer> {
    @Override
    public Integer convert(String text) {
      return number(Integer::valueOf, "a whole number up to " + Integer.MAX_VALUE, text);
    }
  }

  /** A number that need not be whole. */
  public static final class AnyNumber implements ITypeConverter<Double> {
    @Override
    public Double convert(String text) {
      return number(Double::valueOf, "a number", text);
    }
  }

  private static <T> T number(Function<String, T> parser, String kind, String text) {
    try {
      return parser.apply(text);
    } catch (NumberFormatException e) {
      throw new TypeConversionException("must be " + kind + ", is " + text);
    }
  }

  /** A time of at least 1 ms: {@code 500}, {@code 500ms}, {@code 1.5s}, {@code 1m}. */
  public static final class Time implements ITypeConverter<Duration> {
    @Override
    public Duration convert(String text) {
      return converted(SettingText::time, text);
    }
  }
}
