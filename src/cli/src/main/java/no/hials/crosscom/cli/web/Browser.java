package no.hials.crosscom.cli.web;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Opens a link in the user's browser, by the command of the desktop. */
final class Browser {
  private Browser() {}

  /** Opens a link; returns why it could not, or empty. */
  static Optional<String> open(String link) {
    String system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
    List<String> command =
        system.startsWith("windows")
            ? List.of("rundll32", "url.dll,FileProtocolHandler", link)
            : system.startsWith("mac") ? List.of("open", link) : List.of("xdg-open", link);
    try {
      new ProcessBuilder(command)
          .redirectOutput(ProcessBuilder.Redirect.DISCARD)
          .redirectError(ProcessBuilder.Redirect.DISCARD)
          .start();
      return Optional.empty();
    } catch (IOException e) {
      return Optional.of("cannot open a browser: " + e.getMessage());
    }
  }
}
