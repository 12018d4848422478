package no.hials.crosscom.lab.plot;

import java.io.IOException;

/** Says that no text can be drawn, since this machine has no fonts that Java finds. */
public final class NoFontsException extends IOException {
  private static final long serialVersionUID = 1L;

  NoFontsException(Throwable cause) {
    super(
        "a picture needs a font for its texts, and Java finds none here; install fontconfig and a"
            + " font such as DejaVu (on Debian: apt install fontconfig fonts-dejavu-core)",
        cause);
  }
}
