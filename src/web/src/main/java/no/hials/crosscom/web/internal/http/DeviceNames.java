package no.hials.crosscom.web.internal.http;

import java.util.regex.Pattern;

/** The names by which Windows opens devices, in any folder and with any ending. */
public final class DeviceNames {
  private static final Pattern DEVICE =
      Pattern.compile("CON|PRN|AUX|NUL|(?:COM|LPT)[0-9¹²³]", Pattern.CASE_INSENSITIVE);

  private DeviceNames() {}

  /** Returns whether a name without its ending is that of a device. */
  public static boolean isDevice(String name) {
    return DEVICE.matcher(name).matches();
  }
}
