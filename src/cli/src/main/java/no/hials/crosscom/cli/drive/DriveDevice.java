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

/** An open input device, and its properties for the command. */
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

  /**
   * The device that the user chose.
   *
   * @param usualDeadZone the dead zone if the user sets none: sticks do not rest at exactly 0
   */
  record Choice(double usualDeadZone, Opening opening) {
    /** Opens it. The keyboard takes the terminal, so no questions are possible afterwards. */
    DriveDevice open(double deadZone) throws FileException {
      try {
        return opening.open(deadZone);
      } catch (FileException e) {
        throw e;
      } catch (IOException e) {
        throw new FileException(String.valueOf(e.getMessage()), e);
      }
    }
  }

  /** Opens a device. */
  @FunctionalInterface
  interface Opening {
    DriveDevice open(double deadZone) throws IOException;
  }

  private static DriveDevice udp(@Nullable String host, int port, double deadZone)
      throws IOException {
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

  private static DriveDevice csv(Path file, double deadZone) throws IOException {
    try {
      return new DriveDevice(CsvReplay.load(file), deadZone, "replaying " + file);
    } catch (IOException e) {
      throw String.valueOf(e.getMessage()).contains("line ")
          ? e
          : FileException.cannot("read", file, e);
    }
  }

  /** Reads {@code keyboard}, {@code gamepad}, {@code udp[:[ADDRESS:]PORT]} or {@code csv:FILE}. */
  static final class Converter implements ITypeConverter<Choice> {
    private static final Pattern UDP = Pattern.compile("udp(?::(?:(.+):)?(\\d{1,5}))?");

    @Override
    public Choice convert(String text) {
      Matcher udp = UDP.matcher(text);
      if (text.equals("keyboard")) {
        return new Choice(0, zone -> new DriveDevice(KeyboardInput.open(), zone, KEYS));
      } else if (text.equals("gamepad")) {
        String greeting = "hold a shoulder button to move";
        return new Choice(0.15, zone -> new DriveDevice(GamepadInput.open(), zone, greeting));
      } else if (text.startsWith("csv:") && text.length() > "csv:".length()) {
        Path file = Path.of(text.substring("csv:".length()));
        return new Choice(0, zone -> csv(file, zone));
      } else if (udp.matches()) {
        String host = udp.group(1);
        String port = udp.group(2);
        int number = port == null ? USUAL_PORT : new Converters.ListeningPort().convert(port);
        return new Choice(0, zone -> udp(host, number, zone));
      }
      throw new TypeConversionException(
          "must be keyboard, gamepad, udp, udp:PORT, udp:ADDRESS:PORT or csv:FILE, is " + text);
    }
  }

  /** Returns instructions for the user. */
  String greeting() {
    return greeting;
  }

  /** Returns whether the user has quit, or a recording has been replayed to its last line. */
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
