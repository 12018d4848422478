package no.hials.crosscom.protocol.server;

import no.hials.crosscom.protocol.Version;
import no.hials.crosscom.protocol.code.BuildType;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * The version, clock and host of a C3 Bridge (type 13).
 *
 * @param major u8, of the version
 * @param minor u8, of the version
 * @param build u8
 * @param time u16 eight times; the controller's clock, in UTC
 * @param computerName WSTRING: u16 count of characters and UTF-16, little-endian
 */
public record ServerInformation(
    int major, int minor, Code<BuildType> build, SystemTime time, String computerName) {

  /** Checks the ranges. */
  public ServerInformation {
    Ranges.u8("major", major);
    Ranges.u8("minor", minor);
    Ranges.u8("build", build.number());
  }

  /**
   * Returns the version without its third number, which the server does not send.
   *
   * @return the version; its third number is 0
   */
  public Version version() {
    return new Version(major, minor, 0);
  }
}
