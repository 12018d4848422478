package no.hials.crosscom.protocol;

import java.util.Comparator;

/**
 * A version of C3 Bridge.
 *
 * @param major 0 or more
 * @param minor 0 or more
 * @param patch 0 or more; 0 if the server does not report it
 */
public record Version(int major, int minor, int patch) implements Comparable<Version> {
  private static final Comparator<Version> ORDER =
      Comparator.comparingInt(Version::major)
          .thenComparingInt(Version::minor)
          .thenComparingInt(Version::patch);

  /** Checks the ranges. */
  public Version {
    if (major < 0 || minor < 0 || patch < 0) {
      throw new IllegalArgumentException(
          "a version has no negative number, has " + major + "." + minor + "." + patch);
    }
  }

  @Override
  public int compareTo(Version other) {
    return ORDER.compare(this, other);
  }

  /** Returns the version as the server prints it: with the third number only if it is not 0. */
  @Override
  public String toString() {
    return major + "." + minor + (patch == 0 ? "" : "." + patch);
  }
}
