package no.hials.crosscom.simulator.internal.files;

import java.util.Locale;
import org.jspecify.annotations.Nullable;

/**
 * A file of an archive.
 *
 * @param path its path in the archive, with slashes
 * @param content its bytes, which must not change any more; empty if it was refused
 * @param refusal the reason why it was not read; null if it was
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record ArchivedFile(String path, byte[] content, @Nullable String refusal) {

  /** Returns the last part of the path. */
  public String name() {
    return path.substring(path.lastIndexOf('/') + 1);
  }

  /** Returns whether the name is that of a program or a data list. */
  public boolean isModule() {
    return isModule(path);
  }

  static boolean isModule(String path) {
    String name = path.toLowerCase(Locale.ROOT);
    return name.endsWith(".src") || name.endsWith(".sub") || name.endsWith(".dat");
  }
}
