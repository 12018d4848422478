package no.hials.crosscom.kafka.internal;

/** The version of the plugin. */
public final class Versions {
  private Versions() {}

  /** Returns the version in the manifest of the jar, or {@code unknown}. */
  public static String own() {
    String version = Versions.class.getPackage().getImplementationVersion();
    return version == null ? "unknown" : version;
  }
}
