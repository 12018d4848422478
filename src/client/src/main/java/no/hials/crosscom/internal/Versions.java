package no.hials.crosscom.internal;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.protocol.Version;
import org.jspecify.annotations.Nullable;

/**
 * Reads what C3 Bridge answers to {@code @PROXY_VERSION}
 * (docs/reference/c3-messages.md#internal-variables).
 */
public final class Versions {
  private static final Pattern FORM =
      Pattern.compile("(\\d{1,5})\\.(\\d{1,5})(?:\\.(\\d{1,5}))?(?:\\s.*)?");

  private Versions() {}

  /** Reads a text such as {@code 1.4 (OPEN SOURCE)}; returns null if it is not a version. */
  public static @Nullable Version parse(String text) {
    Matcher matcher = FORM.matcher(text);
    if (!matcher.matches()) {
      return null;
    }
    String patch = matcher.group(3);
    return new Version(
        Integer.parseInt(matcher.group(1)),
        Integer.parseInt(matcher.group(2)),
        patch == null ? 0 : Integer.parseInt(patch));
  }
}
