package no.hials.crosscom.kafka.internal;

/** The version of the plugin. */
public final class ConnectorVersion {
  private ConnectorVersion() {}

  /** Returns the version in the manifest of the jar, or {@code unknown}. */
  public static String own() {
    String version = ConnectorVersion.class.getPackage().getImplementationVersion();
    return version == null ? "unknown" : version;
  }
}
