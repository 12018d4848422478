package no.hials.crosscom.cli.base;

import picocli.CommandLine.IVersionProvider;

/** Returns the version that the build writes into the jar's manifest. */
public final class VersionProvider implements IVersionProvider {
  @Override
  public String[] getVersion() {
    String version = VersionProvider.class.getPackage().getImplementationVersion();
    return new String[] {"jopenshowvar " + (version == null ? "(not from a jar)" : version)};
  }
}
