package no.hials.crosscom.lab.plot;

import java.io.IOException;

/** Thrown when no text can be drawn because Java finds no fonts. */
public final class NoFontsException extends IOException {
  private static final long serialVersionUID = 1L;

  NoFontsException(Throwable cause) {
    super(
        "a picture needs a font for its texts, and Java finds none here; install fontconfig and a"
            + " font such as DejaVu (on Debian: apt install fontconfig fonts-dejavu-core)",
        cause);
  }
}
