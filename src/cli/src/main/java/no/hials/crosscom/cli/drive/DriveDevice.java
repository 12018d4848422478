package no.hials.crosscom.cli.drive;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cli.base.Converters;
import no.hials.crosscom.control.input.CsvReplay;
import no.hials.crosscom.control.input.GamepadInput;
import no.hials.crosscom.control.input.Input;
import no.hials.crosscom.control.input.InputDevice;
import no.hials.crosscom.control.input.KeyboardInput;
import no.hials.crosscom.control.input.UdpJsonInput;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** An input device that is open, and what the command has to know of it. */
final class DriveDevice implements InputDevice {
  private static final int USUAL_PORT = 7070;
  private static final String KEYS =
      "w s a d r f: +X -X +Y -Y +Z -Z or A1 A2 A3, u j i k o l: A B C or A4 A5 A6; space stops,"
          + " + - faster, slower, q ends";

  private final InputDevice device;
  private final InputDevice shaped;
  private final String greeting;
  private volatile Input latest = Input.NONE;

  private DriveDevice(InputDevice device, double deadZone, String greeting) {
    this.device = device;
    this.shaped = device.shaped(deadZone, 1);
    this.greeting = greeting;
  }

  /** Which device the user wants. */
  record Choice(Kind kind, @Nullable String host, int port, @Nullable Path file) {
    enum Kind {
      KEYBOARD,
      GAMEPAD,
      UDP,
      CSV
    }

    /** Returns the dead zone if the user does not: sticks do not come to rest at 0 exactly. */
    double usualDeadZone() {
      return kind == Kind.GAMEPAD ? 0.15 : 0;
    }

    /** Opens it. The keyboard takes the terminal, so that nobody can be asked any more. */
    DriveDevice open(double deadZone) throws FileException {
      try {
        return switch (kind) {
          case KEYBOARD -> new DriveDevice(KeyboardInput.open(), deadZone, KEYS);
          case GAMEPAD ->
              new DriveDevice(GamepadInput.open(), deadZone, "hold a shoulder button to move");
          case UDP -> udp(deadZone);
          case CSV -> new DriveDevice(CsvReplay.load(path()), deadZone, "replaying " + path());
        };
      } catch (IOException e) {
        throw kind == Kind.CSV && !String.valueOf(e.getMessage()).contains("line ")
            ? FileException.cannot("read", path(), e)
            : new FileException(String.valueOf(e.getMessage()), e);
      }
    }

    private Path path() {
      return file == null ? Path.of("") : file;
    }

    private DriveDevice udp(double deadZone) throws IOException {
      InetAddress address =
          host == null ? InetAddress.getLoopbackAddress() : InetAddress.getByName(host);
      UdpJsonInput udp = UdpJsonInput.listen(new InetSocketAddress(address, port));
      String warning =
          address.isLoopbackAddress() ? "" : "; anyone who reaches this port can move the robot";
      return new DriveDevice(
          udp,
          deadZone,
          "listening for JSON on UDP " + address.getHostAddress() + ":" + udp.port() + warning);
    }
  }

  /** Reads {@code keyboard}, {@code gamepad}, {@code udp[:[ADDRESS:]PORT]} or {@code csv:FILE}. */
  static final class Converter implements ITypeConverter<Choice> {
    private static final Pattern UDP = Pattern.compile("udp(?::(?:(.+):)?(\\d{1,5}))?");

    @Override
    public Choice convert(String text) {
      Matcher udp = UDP.matcher(text);
      if (text.equals("keyboard")) {
        return new Choice(Choice.Kind.KEYBOARD, null, 0, null);
      } else if (text.equals("gamepad")) {
        return new Choice(Choice.Kind.GAMEPAD, null, 0, null);
      } else if (text.startsWith("csv:") && text.length() > "csv:".length()) {
        return new Choice(Choice.Kind.CSV, null, 0, Path.of(text.substring("csv:".length())));
      } else if (udp.matches()) {
        int port =
            udp.group(2) == null
                ? USUAL_PORT
                : new Converters.ListeningPort().convert(udp.group(2));
        return new Choice(Choice.Kind.UDP, udp.group(1), port, null);
      }
      throw new TypeConversionException(
          "must be keyboard, gamepad, udp, udp:PORT, udp:ADDRESS:PORT or csv:FILE, is " + text);
    }
  }

  /** Returns instructions for the user. */
  String greeting() {
    return greeting;
  }

  /**
   * Returns whether the user, or a recording, has come to the end; a recording after its last line.
   */
  boolean isEnded(boolean standing) {
    return device instanceof KeyboardInput keyboard
        ? keyboard.isEnded()
        : standing && device instanceof CsvReplay replay && replay.isOver();
  }

  /** Returns the last state that the loop saw. */
  Input latest() {
    return latest;
  }

  @Override
  public Input read() throws IOException {
    Input input = shaped.read();
    latest = input;
    return input;
  }

  @Override
  public void close() throws IOException {
    device.close();
  }
}
